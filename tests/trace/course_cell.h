#pragma once
// The adaptive pattern of the course profile, sample by sample.

#include "scenefile/trace/course_samples.h"

#include <array>
#include <concepts>

namespace scenefile::course {

/// The color at a point of the picture, clamped to [0, 1].
template <typename F>
concept ColorAt = requires(F f, glm::dvec2 p) {
  { f(p) } -> std::convertible_to<Color>;
};

/// The average over a square cell: four samples in its quadrants; those that differ from a
/// horizontal or vertical neighbor are refined as cells.
template <ColorAt F>
Color cell(const F& color_at, const glm::dvec2& corner, double size, int level) {
  std::array<Color, 4> colors;
  for (int i = 0; i < 4; ++i) {
    colors[static_cast<std::size_t>(i)] = color_at(center_of_quadrant(corner, size, i));
  }
  Color sum(0);
  for (int i = 0; i < 4; ++i) {
    sum += uneven(colors, i) && level < max_level
               ? cell(color_at, quadrant(corner, size, i), size / 2, level + 1)
               : colors[static_cast<std::size_t>(i)];
  }
  return sum / 4.0;
}

}  // namespace scenefile::course
