#pragma once
// The two sampling patterns of the course's reference pictures.

#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/tracer.h"

#include <array>
#include <vector>

namespace scenefile {

/// The color at a point of the picture, clamped to [0, 1].
template <typename F>
concept ColorAt = requires(F f, glm::dvec2 p) {
  { f(p) } -> std::convertible_to<Color>;
};

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
inline glm::dvec2 middle_of_quadrant(const glm::dvec2& corner, double size, int index) {
  return quadrant(corner, size, index) + size / 4;
}

/// Whether a quadrant differs from its horizontal or vertical neighbor in the cell.
inline bool uneven(const std::array<Color, 4>& colors, int index) {
  const auto i = static_cast<std::size_t>(index);
  return differ(colors[i], colors[i ^ 1]) || differ(colors[i], colors[i ^ 2]);
}

/// The average over a square cell: four samples in its quadrants; those that differ from a
/// horizontal or vertical neighbor are refined as cells.
template <ColorAt F>
Color cell(const F& color_at, const glm::dvec2& corner, double size, int level) {
  std::array<Color, 4> colors;
  for (int i = 0; i < 4; ++i) {
    colors[static_cast<std::size_t>(i)] = color_at(middle_of_quadrant(corner, size, i));
  }
  Color sum(0);
  for (int i = 0; i < 4; ++i) {
    sum += uneven(colors, i) && level < max_level
               ? cell(color_at, quadrant(corner, size, i), size / 2, level + 1)
               : colors[static_cast<std::size_t>(i)];
  }
  return sum / 4.0;
}

/// Which samples of cell() are replaced by finer ones: for each sample, the index of the one whose
/// quadrant contains it; no_index for the first four. `points` are in sampling order.
std::vector<std::uint32_t> refined_samples(const std::vector<glm::dvec2>& points);

/// The course's lens samples, in apertures.
inline constexpr std::array<std::array<double, 2>, 8> lens_points{
    {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}, {-0.5, 0}, {0.5, 0}, {0, -0.5}, {0, 0.5}}};

}  // namespace course

/// A pixel of the course profile: a sample at its center, the adaptive cell, or the lens samples.
Color course_pixel(const Tracer& tracer, const CameraRays& camera, int x, int y, RayCounts& counts);

}  // namespace scenefile
