#include "scenefile/trace/sequence.h"
#include "trace/course_cell.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace scenefile {
namespace {

TEST(CourseCell, EvenPixelsTakeFourSamples) {
  std::vector<glm::dvec2> places;
  const Color c = course::cell(
      [&](const glm::dvec2& p) {
        places.push_back(p);
        return Color(0.25);
      },
      {3, 5}, 1, 1);
  EXPECT_EQ(c, Color(0.25));
  ASSERT_EQ(places.size(), 4u);
  EXPECT_EQ(places[0], glm::dvec2(3.25, 5.25));
  EXPECT_EQ(places[3], glm::dvec2(3.75, 5.75));
}

// The number of samples of a pixel with a vertical edge at x.
int samples_at_edge(double x, double step) {
  int count = 0;
  course::cell(
      [&](const glm::dvec2& p) {
        ++count;
        return Color(p.x < x ? 0 : step);
      },
      {0, 0}, 1, 1);
  return count;
}

TEST(CourseCell, RefinesOnlyAboveTheThreshold) {
  EXPECT_EQ(samples_at_edge(0.5, 50.0 / 255), 4);
  EXPECT_GT(samples_at_edge(0.5, 50.0 / 255 + 1e-9), 4);
}

TEST(CourseCell, EndsAfterThreeLevels) {
  // The edge runs between the halves: all four quadrants are refined once, and are uniform then.
  EXPECT_EQ(samples_at_edge(0.5, 1), 4 + 16);
  // The edge is between the columns of the second level on the left, so the left two quadrants
  // there are refined again.
  EXPECT_EQ(samples_at_edge(0.3, 1), 4 + 4 * 4 + 2 * 4 * 4);
}

TEST(CourseCell, DiagonalNeighborsAreNotCompared) {
  int count = 0;
  const Color corners[4] = {Color(0), Color(0.15), Color(0.15), Color(0.3)};
  course::cell(
      [&](const glm::dvec2& p) {
        ++count;
        return corners[(p.x > 0.5 ? 1 : 0) + (p.y > 0.5 ? 2 : 0)];
      },
      {0, 0}, 1, 1);
  EXPECT_EQ(count, 4);
}

TEST(Sequence, EveryPowerOfTwoFillsEveryGrid) {
  for (const std::uint32_t pattern : {0u, 1u, 12345u}) {
    for (std::uint32_t bits = 0; bits <= 8; ++bits) {
      for (std::uint32_t x_bits = 0; x_bits <= bits; ++x_bits) {
        std::set<std::pair<int, int>> boxes;
        for (std::uint32_t i = 0; i < (1u << bits); ++i) {
          const glm::dvec2 p = stratified_2d(i, pattern);
          boxes.insert({int(p.x * (1 << x_bits)), int(p.y * (1 << (bits - x_bits)))});
        }
        EXPECT_EQ(boxes.size(), 1u << bits);
      }
    }
  }
}

TEST(Sequence, PatternsDiffer) {
  EXPECT_NE(stratified_2d(0, 1), stratified_2d(0, 2));
  EXPECT_NE(mixed_bits(1, 2), mixed_bits(2, 1));
}

TEST(Sequence, DiskKeepsAreas) {
  int inner = 0;
  constexpr int n = 4096;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double r = glm::length(disk_of_square(stratified_2d(i, 7)));
    EXPECT_LE(r, 1 + 1e-12);
    inner += r < 0.5 ? 1 : 0;
  }
  EXPECT_NEAR(inner / double(n), 0.25, 0.01);
  EXPECT_EQ(disk_of_square({0.5, 0.5}), glm::dvec2(0));
}

}  // namespace
}  // namespace scenefile
