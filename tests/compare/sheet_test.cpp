#include "scenefile/compare/sheet.h"

#include "compare/sample_pictures.h"

#include <gtest/gtest.h>

#include <array>

namespace scenefile::compare_test {
namespace {

int brightness(const std::uint8_t* rgb) {
  return rgb[0] + rgb[1] + rgb[2];
}

TEST(Sheet, MagmaRunsFromBlackToPaleYellow) {
  std::array<std::uint8_t, 3> rgb{};
  int last = -1;
  for (const double value : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    magma(value, rgb.data());
    EXPECT_GT(brightness(rgb.data()), last);
    last = brightness(rgb.data());
  }
  EXPECT_GT(rgb[0], 245);
  magma(0, rgb.data());
  EXPECT_LT(brightness(rgb.data()), 6);
}

TEST(Sheet, HeatMapShowsWhereAndHowMuch) {
  const Texture a = blank(3, 1, {10, 10, 10});
  Texture b = a;
  b.rgb[3] = 11;
  b.rgb[6] = 200;
  const Texture map = heat_map(a, b);
  EXPECT_LT(brightness(map.texel(0, 0)), brightness(map.texel(1, 0)));
  EXPECT_LT(brightness(map.texel(1, 0)), brightness(map.texel(2, 0)));
}

TEST(Sheet, HeatMapOfOtherSizesCoversBoth) {
  const Texture map = heat_map(blank(3, 1), blank(1, 2));
  EXPECT_EQ(map.width, 3);
  EXPECT_EQ(map.height, 2);
  EXPECT_GT(map.texel(2, 0)[0], 245);
  EXPECT_LT(map.texel(0, 0)[0], 3);
}

TEST(Sheet, ReducedPicturesAreAverages) {
  const Texture small = reduced(pattern(40, 20, 0), 40);
  EXPECT_EQ(small.rgb, pattern(40, 20, 0).rgb);
  Texture halves = blank(6, 4, {0, 100, 7});
  for (int i = 0; i < 6 * 4; ++i) {
    halves.rgb[3 * i] = i % 2 == 0 ? 50 : 70;
  }
  const Texture half = reduced(halves, 3);
  EXPECT_EQ(half.width, 3);
  EXPECT_EQ(half.height, 2);
  EXPECT_EQ(half.texel(2, 1)[0], 60);
  EXPECT_EQ(half.texel(2, 1)[2], 7);
}

TEST(Sheet, PicturesAreInColumnsOfEqualWidth) {
  const Texture a = blank(3, 2, {1, 2, 3});
  const Texture b = blank(4, 5, {7, 8, 9});
  const std::array<const Texture*, 2> both{&a, &b};
  const Texture sheet = side_by_side(both);
  EXPECT_EQ(sheet.width, 8 + 4 + 8 + 4 + 8);
  EXPECT_EQ(sheet.height, 8 + 5 + 8);
  EXPECT_EQ(sheet.texel(8, 8)[2], 3);
  EXPECT_EQ(sheet.texel(11, 8)[2], 96);
  EXPECT_EQ(sheet.texel(20, 8)[2], 9);
  EXPECT_EQ(sheet.texel(0, 0)[0], 96);
  const Texture strip = side_by_side(both, 0);
  EXPECT_EQ(strip.width, 4 + 4);
  EXPECT_EQ(strip.height, 5);
  EXPECT_EQ(strip.texel(4, 0)[0], 7);
}

}  // namespace
}  // namespace scenefile::compare_test
