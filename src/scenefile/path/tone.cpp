#include "scenefile/path/tone.h"

#include "scenefile/path/lamps.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

Image tone_mapped(Image image, Tone tone, double exposure) {
  const double gain = std::exp2(exposure);
  const auto color = [&](std::size_t at) {
    return gain * Color(image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]);
  };
  double white = 0;
  for (std::size_t at = 0; at < image.rgb.size(); at += 3) {
    white = std::max(white, luminance(color(at)));
  }
  for (std::size_t at = 0; at < image.rgb.size(); at += 3) {
    Color c = color(at);
    if (tone == Tone::course && white > 0) {
      const double bright = luminance(c);
      c = glm::sqrt(glm::max(c * ((1 + bright / (white * white)) / (1 + bright)), Color(0)));
    }
    for (int i = 0; i < 3; ++i) {
      image.rgb[at + i] = static_cast<float>(std::min(c[i], 1e38));
    }
  }
  return image;
}

}  // namespace scenefile
