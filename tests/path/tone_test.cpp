#include "scenefile/path/tone.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scenefile {
namespace {

Image two_pixels() {
  Image image(2, 1);
  image.rgb = {0.2f, 0.4f, 0.1f, 3, 2, 1};
  return image;
}

double luminance_of(const float* c) {
  return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}

TEST(PathTone, CourseCurveIsReinhardsWithGamma2) {
  const Image linear = two_pixels();
  const Image toned = tone_mapped(linear, Tone::course, 0);
  const double white = luminance_of(linear.pixel(1, 0));
  for (int x = 0; x < 2; ++x) {
    const double bright = luminance_of(linear.pixel(x, 0));
    const double mapped = bright * (1 + bright / (white * white)) / (1 + bright);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(toned.pixel(x, 0)[c], std::sqrt(linear.pixel(x, 0)[c] * mapped / bright), 1e-6);
    }
  }
  // The brightest luminance becomes 1.
  float squares[3];
  for (int c = 0; c < 3; ++c) {
    squares[c] = toned.pixel(1, 0)[c] * toned.pixel(1, 0)[c];
  }
  EXPECT_NEAR(luminance_of(squares), 1, 1e-6);
}

TEST(PathTone, ExposureIsInStops) {
  const Image brighter = tone_mapped(two_pixels(), Tone::none, 2);
  for (int i = 0; i < 6; ++i) {
    EXPECT_FLOAT_EQ(brighter.rgb[i], 4 * two_pixels().rgb[i]);
  }
  Image doubled = two_pixels();
  for (float& value : doubled.rgb) {
    value *= 2;
  }
  EXPECT_EQ(tone_mapped(two_pixels(), Tone::course, 1).rgb,
            tone_mapped(doubled, Tone::course, 0).rgb);
}

TEST(PathTone, BlackStaysBlackAndBrightStaysFinite) {
  EXPECT_EQ(tone_mapped(Image(2, 2), Tone::course, 0).rgb, Image(2, 2).rgb);
  Image image(1, 1);
  image.rgb = {1e38f, 1e38f, 1e38f};
  for (const float value : tone_mapped(image, Tone::course, 10).rgb) {
    EXPECT_TRUE(std::isfinite(value));
  }
}

}  // namespace
}  // namespace scenefile
