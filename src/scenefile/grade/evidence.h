#pragma once
// Sample points of two pictures, scores of predicted colors at these points, and the thresholds for
// a claim. Shared by the searches for causes; internal to grade. All colors in 1/255.

#include "scenefile/asset/image.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace scenefile {

// A claim must satisfy the first three thresholds.
inline constexpr double min_explained = 0.85;  ///< share of the difference, for a claim
inline constexpr double min_exact = 0.75;      ///< share of the differing pixels that it must match
inline constexpr double max_broken = 0.03;     ///< share of the correct pixels that it may break
inline constexpr double min_partial = 0.5;     ///< minimum for a partial cause
inline constexpr std::size_t few_pixels = 12;  ///< fewer differing pixels are not evidence
/// Share of pixels where our picture of the scene may differ from the reference.
inline constexpr double max_unlike = 0.1;

inline constexpr double exact_within = 3;
inline constexpr double right_within = 8;
inline constexpr double tolerance = 2;

/// Colors that differ by no more are equal; `noisy`: after compression or scaling.
inline double rounding_with(bool noisy) {
  return noisy ? 3 : 1.1;
}

/// How many of some points have a property. The share of no points is 1.
struct Share {
  std::size_t part = 0;
  std::size_t all = 0;
  void add(bool is_part) {
    part += is_part ? 1 : 0;
    ++all;
  }
  double value() const {
    return all > 0 ? static_cast<double>(part) / static_cast<double>(all) : 1;
  }
};

struct Point {
  int x = 0;
  int y = 0;
  glm::dvec3 test{0};
  glm::dvec3 low{0};  ///< values in [low, high] count as equal
  glm::dvec3 high{0};
  double noise = 0;   ///< as SceneView::noise; [low, high] includes it
  double weight = 1;  ///< number of pixels that it represents
  bool differs = false;
};

inline glm::dvec3 at(const Texture& t, int x, int y) {
  const std::uint8_t* p = t.texel(x, y);
  return {p[0], p[1], p[2]};
}
/// The distance of the value to the range, by channel.
inline glm::dvec3 outside(const glm::dvec3& value, const glm::dvec3& low, const glm::dvec3& high) {
  return glm::max(glm::dvec3(0), glm::max(low - value, value - high));
}
inline double largest_of(const glm::dvec3& v) {
  return std::max({v.x, v.y, v.z});
}

/// The minimum and maximum over the neighboring pixels.
struct Range {
  glm::dvec3 low, high;
  bool calm() const { return largest_of(high - low) <= 12; }
};
Range around(const Texture& t, int x, int y);
/// By how much the colors at a pixel differ from all that the other picture has around it.
double off_beyond_edges(const Texture& a, const Texture& b, int x, int y);

using Colors = std::vector<glm::dvec3>;  ///< by point; full brightness is 255, not clamped

struct Score {
  double left = 0;    ///< remaining error beyond the tolerance, in 1/255 * pixels
  double raw = 0;     ///< the same without tolerance
  double exact = 0;   ///< weight of points that differed and now match
  double broken = 0;  ///< weight of points that matched and no longer do
};
Score score(const std::vector<Point>& points, std::size_t count, const Colors& colors);

/// The correlation of pairs of values, added one by one.
class Correlation {
 public:
  void add(double x, double y);
  /// From -1 to 1; 0 if all values of one side are equal.
  double value() const;

 private:
  double n_ = 0, x_ = 0, y_ = 0, xx_ = 0, yy_ = 0, xy_ = 0;
};

/// The pixels that differ by more than edges and rounding explain, and the others.
struct Pixels {
  std::vector<std::uint32_t> different;
  std::vector<std::uint32_t> same;
  std::vector<std::uint32_t> off;  ///< pixels that differ by more than 8/255, including edges
};
/// Whether at most `max_share_same` of the pixels differ, and nowhere all of 3x3 pixels: those at
/// an edge do not fill a square, but a small object that is missing does.
bool only_details(const Pixels& pixels, const Texture& test);
/// `noise`: as in SceneView. Pixels that are no evidence are left out.
Pixels sorted_pixels(const Texture& reference, const Texture& test,
                     const std::vector<float>& noise = {});

/// Values up to this look black.
inline constexpr double dark_up_to = 16;

/// Adds points at pixels that are chosen at random, but reproducibly. `strict`: the test's own
/// colors count at edges as well. `noise`: as in SceneView.
void add_points(const Texture& reference, const Texture& test, std::vector<std::uint32_t> pixels,
                std::size_t count, bool differs, bool strict, std::mt19937& random,
                std::vector<Point>& points, const std::vector<float>& noise = {});

/// A point of `a`, one of `b`, and so on, and the rest of the longer one.
std::vector<Point> alternating(const std::vector<Point>& a, const std::vector<Point>& b);

/// Adds points at the pixels that differ. In a nearly black picture, the few pixels that are not
/// dark get half of the weight: any mistake that makes the others black explains them.
void add_differing_points(const Texture& reference, const Texture& test,
                          const std::vector<std::uint32_t>& pixels, std::size_t count,
                          std::mt19937& random, std::vector<Point>& points,
                          const std::vector<float>& noise = {});

}  // namespace scenefile
