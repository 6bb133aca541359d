// The expected values come from scikit-image: structural_similarity with gaussian_weights, sigma
// 1.5, use_sample_covariance off.

#include "scenefile/compare/ssim.h"

#include "compare/sample_pictures.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace scenefile::compare_test {
namespace {

constexpr double ssim_tolerance = 1e-5;

TEST(Ssim, EqualPicturesAreOne) {
  const Texture a = pattern(40, 30, 3);
  EXPECT_NEAR(ssim(a, a), 1, 1e-9);
}

TEST(Ssim, PatternsOfAllKinds) {
  const Texture a = pattern(48, 32, 0);
  EXPECT_NEAR(ssim(a, pattern(48, 32, 1)), 0.920568, ssim_tolerance);
  EXPECT_NEAR(ssim(a, darkened(a, 8)), 0.995739, ssim_tolerance);
  EXPECT_NEAR(ssim(a, mirrored(a)), 0.560461, ssim_tolerance);
  EXPECT_NEAR(ssim(a, blank(48, 32)), 0.000361, ssim_tolerance);
}

TEST(Ssim, IsSymmetric) {
  const Texture a = pattern(20, 20, 1);
  const Texture b = pattern(20, 20, 5);
  EXPECT_NEAR(ssim(a, b), ssim(b, a), 1e-12);
}

// Pictures are compared tile by tile.
TEST(Ssim, DoesNotDependOnThePlaceInThePicture) {
  const Texture a = blank(400, 30, {90, 120, 200});
  const auto with_a_spot = [&](int x) {
    Texture b = a;
    b.rgb[3 * (std::size_t{15} * 400 + x)] = 255;
    return ssim(a, b);
  };
  EXPECT_LT(with_a_spot(64), 0.9999);
  for (const int x : {125, 127, 128, 131, 260}) {
    EXPECT_NEAR(with_a_spot(x), with_a_spot(64), 1e-12) << x;
  }
}

TEST(Ssim, PicturesSmallerThanTheWindow) {
  const Texture a = pattern(4, 3, 1);
  EXPECT_NEAR(ssim(a, a), 1, 1e-9);
  EXPECT_LT(ssim(a, blank(4, 3)), 0.5);
}

TEST(Ssim, OtherSizesAreNotAlike) {
  EXPECT_EQ(ssim(blank(4, 4), blank(4, 5)), 0);
}

}  // namespace
}  // namespace scenefile::compare_test
