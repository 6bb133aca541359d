#include "scenefile/asset/image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <new>

namespace scenefile {
namespace {

TEST(ImageSize, BeyondMaxSizeIsOutOfMemory) {
  EXPECT_THROW(Image(1 << 30, 1 << 30), std::bad_alloc);
}

TEST(Quantize, TruncatesOrRounds) {
  EXPECT_EQ(quantize(0.5f, Rounding::truncate), 127);
  EXPECT_EQ(quantize(0.5f, Rounding::nearest), 128);
  EXPECT_EQ(quantize(254.9f / 255, Rounding::truncate), 254);
  EXPECT_EQ(quantize(254.9f / 255, Rounding::nearest), 255);
  EXPECT_EQ(quantize(0.4f / 255, Rounding::nearest), 0);
  EXPECT_EQ(quantize(0.6f / 255, Rounding::nearest), 1);
}

TEST(Quantize, Clamps) {
  for (const Rounding rounding : {Rounding::truncate, Rounding::nearest}) {
    EXPECT_EQ(quantize(1, rounding), 255);
    EXPECT_EQ(quantize(1e30f, rounding), 255);
    EXPECT_EQ(quantize(std::numeric_limits<float>::infinity(), rounding), 255);
    EXPECT_EQ(quantize(-std::numeric_limits<float>::infinity(), rounding), 0);
    EXPECT_EQ(quantize(-1, rounding), 0);
    EXPECT_EQ(quantize(-0.0f, rounding), 0);
    EXPECT_EQ(quantize(std::nanf(""), rounding), 0);
  }
}

// Truncation must not change the values of an 8-bit file.
TEST(Quantize, InvertsToFloat) {
  Texture texture;
  texture.width = 256;
  texture.height = 1;
  for (int i = 0; i < 256; ++i) {
    texture.rgb.insert(texture.rgb.end(), 3, static_cast<std::uint8_t>(i));
  }
  const Image image = to_float(texture);
  EXPECT_EQ(image.width, 256);
  EXPECT_EQ(image.pixel(255, 0)[1], 1.0f);
  EXPECT_EQ(quantize(image, Rounding::truncate).rgb, texture.rgb);
  EXPECT_EQ(quantize(image, Rounding::nearest).rgb, texture.rgb);
}

TEST(Image, RowZeroIsOnTop) {
  Image image(3, 2);
  image.pixel(2, 1)[0] = 1;
  EXPECT_EQ(image.rgb[3 * (3 * 1 + 2)], 1);
}

}  // namespace
}  // namespace scenefile
