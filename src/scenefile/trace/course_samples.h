#pragma once
// The two sampling patterns of the course's reference pictures.

#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/tracer.h"

#include <array>
#include <vector>

namespace scenefile {

namespace course {

inline constexpr double max_difference = 50.0 / 255;  ///< neighbors that differ by more are refined
inline constexpr int max_level = 3;                   ///< cells of 1, 1/2 and 1/4 pixel

inline bool differ(const Color& a, const Color& b) {
  const Color d = glm::abs(a - b);
  return d.x > max_difference || d.y > max_difference || d.z > max_difference;
}

/// The corner of a quadrant of a cell; index: 0 top left, 1 top right, 2 bottom left, 3 bottom
/// right.
inline glm::dvec2 quadrant(const glm::dvec2& corner, double size, int index) {
  return corner + size / 2 * glm::dvec2(index % 2, index / 2);
}
inline glm::dvec2 center_of_quadrant(const glm::dvec2& corner, double size, int index) {
  return quadrant(corner, size, index) + size / 4;
}

/// Whether a quadrant differs from its horizontal or vertical neighbor in the cell.
inline bool uneven(const std::array<Color, 4>& colors, int index) {
  const auto i = static_cast<std::size_t>(index);
  return differ(colors[i], colors[i ^ 1]) || differ(colors[i], colors[i ^ 2]);
}

/// Quadrants that differ from a horizontal or vertical neighbor are sampled again as cells. Which
/// samples are replaced by finer ones: for each sample, the index of the one whose
/// quadrant contains it; no_index for the first four. `points` are in sampling order.
std::vector<std::uint32_t> refined_samples(const std::vector<glm::dvec2>& points);

/// The course's lens samples, in apertures.
inline constexpr std::array<std::array<double, 2>, 8> lens_points{
    {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}, {-0.5, 0}, {0.5, 0}, {0, -0.5}, {0, 0.5}}};

}  // namespace course

}  // namespace scenefile
