// The expected values come from an independent implementation, written from the paper and the
// constants of its authors' program, with full two-dimensional kernels in double precision.

#include "scenefile/compare/flip.h"

#include "compare/sample_pictures.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace scenefile::compare_test {
namespace {

constexpr double tolerance = 2e-6;

TEST(Flip, EqualPicturesHaveNoError) {
  const Texture a = pattern(40, 30, 3);
  EXPECT_EQ(flip(a, a).max, 0);
  EXPECT_EQ(flip(a, a).mean, 0);
}

TEST(Flip, ColorsWithoutEdges) {
  const auto between = [](std::initializer_list<int> a, std::initializer_list<int> b) {
    return flip(blank(4, 4, a), blank(4, 4, b)).mean;
  };
  EXPECT_NEAR(between({0, 0, 0}, {255, 255, 255}), 0.967380, tolerance);
  // The largest possible error, by definition.
  EXPECT_NEAR(between({0, 255, 0}, {0, 0, 255}), 1, tolerance);
  EXPECT_NEAR(between({255, 0, 0}, {0, 255, 0}), 0.986662, tolerance);
  EXPECT_NEAR(between({128, 128, 128}, {130, 130, 130}), 0.048476, tolerance);
}

struct Expected {
  double mean;
  double max;
  double at;  // one fifth from the left and the top
};

void expect_flip(const Texture& a, const Texture& b, const Expected& expected) {
  const FlipMap map = flip(a, b);
  EXPECT_NEAR(map.mean, expected.mean, tolerance);
  EXPECT_NEAR(map.max, expected.max, tolerance);
  EXPECT_NEAR(map.errors[(a.height / 5) * a.width + a.width / 5], expected.at, tolerance);
}

TEST(Flip, PatternsOfAllKinds) {
  const Texture a = pattern(48, 32, 0);
  expect_flip(a, pattern(48, 32, 1), {0.492081, 0.765346, 0.473507});
  expect_flip(a, darkened(a, 8), {0.179215, 0.215764, 0.177226});
  expect_flip(a, mirrored(a), {0.737814, 0.973454, 0.964477});
  expect_flip(a, blank(48, 32), {0.887312, 0.984817, 0.518283});
}

TEST(Flip, PicturesSmallerThanTheFilters) {
  const Texture a = pattern(9, 40, 0);
  expect_flip(a, pattern(9, 40, 1), {0.609604, 0.984033, 0.507075});
  expect_flip(a, mirrored(a), {0.107703, 0.401497, 0.133331});
}

// Pictures are compared tile by tile.
TEST(Flip, DoesNotDependOnThePlaceInThePicture) {
  const Texture a = blank(400, 30, {90, 120, 200});
  const auto errors = [&](int x) {
    Texture b = a;
    b.rgb[3 * (std::size_t{15} * 400 + x)] = 255;
    const FlipMap map = flip(a, b);
    return std::vector<float>(map.errors.begin() + 15 * 400 + x - 40,
                              map.errors.begin() + 15 * 400 + x + 40);
  };
  const std::vector<float> inside = errors(64);
  EXPECT_GT(inside[40], 0.1F);
  EXPECT_GT(inside[33], 0);
  for (const int x : {120, 127, 128, 131, 260}) {
    EXPECT_EQ(errors(x), inside) << x;
  }
}

TEST(Flip, OtherSizesAreAllWrong) {
  const FlipMap map = flip(blank(4, 4), blank(4, 5));
  EXPECT_EQ(map.mean, 1);
  EXPECT_TRUE(map.errors.empty());
}

}  // namespace
}  // namespace scenefile::compare_test
