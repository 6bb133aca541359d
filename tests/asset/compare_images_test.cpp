#include "scenefile/asset/compare_images.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scenefile {
namespace {

Texture picture(int width, int height, std::vector<std::uint8_t> rgb) {
  return {width, height, std::move(rgb)};
}

TEST(CompareImages, EqualOnes) {
  const Texture a = picture(2, 1, {1, 2, 3, 4, 5, 6});
  const ImageDifference d = compare_images(a, a);
  EXPECT_EQ(d.psnr_db, 99);
  EXPECT_EQ(d.mean, 0);
  EXPECT_EQ(d.max, 0);
  EXPECT_EQ(d.share_over, 0);
  EXPECT_EQ(compare_images(Texture(), Texture()).psnr_db, 99);
}

// Differences 10, 0, 0, 0, 0, 20: mean 5, mean square 500 / 6.
TEST(CompareImages, ByHand) {
  const Texture a = picture(2, 1, {10, 50, 50, 50, 50, 20});
  const Texture b = picture(2, 1, {0, 50, 50, 50, 50, 40});
  const ImageDifference d = compare_images(a, b, 10);
  EXPECT_DOUBLE_EQ(d.mean, 5);
  EXPECT_EQ(d.max, 20);
  EXPECT_DOUBLE_EQ(d.share_over, 0.5) << "10 is not more than 10";
  EXPECT_NEAR(d.psnr_db, 20 * std::log10(255 / std::sqrt(500.0 / 6)), 1e-12);
  EXPECT_NEAR(d.psnr_db, 28.9226, 1e-4);
  EXPECT_EQ(compare_images(a, b, 9).share_over, 1);
  EXPECT_EQ(compare_images(a, b, 20).share_over, 0);
  EXPECT_EQ(compare_images(b, a, 10).psnr_db, d.psnr_db);
}

TEST(CompareImages, BlackAndWhite) {
  const ImageDifference d =
      compare_images(picture(1, 1, {0, 0, 0}), picture(1, 1, {255, 255, 255}));
  EXPECT_DOUBLE_EQ(d.psnr_db, 0);
  EXPECT_EQ(d.mean, 255);
  EXPECT_EQ(d.share_over, 1);
}

// By the formula, a difference of 1 in one of 3 million values exceeds 99 dB.
TEST(CompareImages, IsNeverOver99) {
  Texture a = picture(1000, 1000, std::vector<std::uint8_t>(3'000'000, 7));
  Texture b = a;
  b.rgb[1234567] = 8;
  EXPECT_EQ(compare_images(a, b).psnr_db, 99);
  EXPECT_EQ(compare_images(a, b).max, 1);
}

TEST(CompareImages, DifferentSizesDifferInEverything) {
  const ImageDifference d =
      compare_images(picture(1, 2, {1, 1, 1, 1, 1, 1}), picture(2, 1, {1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(d.psnr_db, 0);
  EXPECT_EQ(d.max, 255);
  EXPECT_EQ(d.share_over, 1);
}

}  // namespace
}  // namespace scenefile
