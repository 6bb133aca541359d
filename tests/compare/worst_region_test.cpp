#include "scenefile/compare/worst_region.h"

#include "compare/sample_pictures.h"

#include <gtest/gtest.h>

namespace scenefile::compare_test {
namespace {

void fill(Texture& t, int x0, int y0, int x1, int y1, int value) {
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      std::fill_n(t.rgb.begin() + 3 * (y * t.width + x), 3, static_cast<std::uint8_t>(value));
    }
  }
}

TEST(WorstRegion, IsTheRectangleThatDiffers) {
  const Texture a = blank(200, 150);
  Texture b = a;
  fill(b, 60, 40, 99, 79, 90);
  fill(b, 150, 120, 152, 122, 255);
  const auto region = worst_region(a, b);
  ASSERT_TRUE(region);
  EXPECT_EQ(region->x0, 60);
  EXPECT_EQ(region->y0, 40);
  EXPECT_EQ(region->x1, 99);
  EXPECT_EQ(region->y1, 79);
  EXPECT_NEAR(region->mean, 90, 1e-9);
  EXPECT_NEAR(region->share, 90.0 * 1600 / (90.0 * 1600 + 255.0 * 9), 1e-9);
}

TEST(WorstRegion, ThePixelIsInsideNotOnTheEdge) {
  const Texture a = blank(120, 90);
  Texture b = a;
  fill(b, 20, 20, 60, 60, 60);
  fill(b, 20, 20, 60, 20, 250);  // the edge differs more
  const auto region = worst_region(a, b);
  ASSERT_TRUE(region);
  EXPECT_GE(region->x, 22);
  EXPECT_GE(region->y, 22);
  EXPECT_LE(region->x, 58);
  EXPECT_LE(region->y, 58);
}

TEST(WorstRegion, NoneWhereNothingDiffers) {
  const Texture a = pattern(64, 48, 1);
  EXPECT_FALSE(worst_region(a, a));
  Texture b = a;
  b.rgb[0] = static_cast<std::uint8_t>(b.rgb[0] ^ 1);
  EXPECT_FALSE(worst_region(a, b));
  EXPECT_FALSE(worst_region(a, blank(32, 48)));
  EXPECT_FALSE(worst_region(Texture(), Texture()));
}

TEST(WorstRegion, SmallPicturesHaveOne) {
  const auto region = worst_region(blank(1, 1), blank(1, 1, {9, 9, 9}));
  ASSERT_TRUE(region);
  EXPECT_EQ(region->x1, 0);
  EXPECT_EQ(region->mean, 9);
}

}  // namespace
}  // namespace scenefile::compare_test
