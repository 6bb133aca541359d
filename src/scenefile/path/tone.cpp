#include "scenefile/path/tone.h"

#include "scenefile/path/lamps.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

Color exposed_color(const float* rgb, double gain) {
  return gain * Color(rgb[0], rgb[1], rgb[2]);
}

double compression(double bright, double white) {
  return (1 + bright / (white * white)) / (1 + bright);
}

}  // namespace

double brightest(std::span<const float> rgb, double exposure) {
  const double gain = std::exp2(exposure);
  double most = 0;
  for (std::size_t at = 0; at < rgb.size(); at += 3) {
    most = std::max(most, luminance(exposed_color(&rgb[at], gain)));
  }
  return most;
}

double course_tone(double bright, double white) {
  return white > 0 ? std::sqrt(std::max(bright, 0.0) * compression(bright, white)) : 0;
}

void map_tones(std::span<float> rgb, Tone tone, double exposure, double white) {
  const double gain = std::exp2(exposure);
  for (std::size_t at = 0; at < rgb.size(); at += 3) {
    Color c = exposed_color(&rgb[at], gain);
    if (tone == Tone::course && white > 0) {
      const double bright = luminance(c);
      c = glm::sqrt(glm::max(c * compression(bright, white), Color(0)));
    }
    for (int i = 0; i < 3; ++i) {
      rgb[at + static_cast<std::size_t>(i)] = stored_float(c[i]);
    }
  }
}

Image tone_mapped(Image image, Tone tone, double exposure) {
  map_tones(image.rgb, tone, exposure, brightest(image.rgb, exposure));
  return image;
}

}  // namespace scenefile
