#include "scenefile/trace/course_samples.h"

#include <algorithm>

namespace scenefile {

namespace {

// The samples of a refined quadrant follow those of its cell, and are inside the quadrant. Links
// the cell whose samples begin at `first`, with quadrants of `half` pixels; returns the index after
// its last sample.
std::size_t link_cell(const std::vector<glm::dvec2>& points, std::size_t first, double half,
                      std::vector<std::uint32_t>& links) {
  std::size_t next = first + 4;
  for (std::size_t i = first; i < first + 4; ++i) {
    const auto in_quadrant = [&] {
      const glm::dvec2 d = glm::abs(points[next] - points[i]);
      return std::max(d.x, d.y) < half / 2;
    };
    if (next < points.size() && in_quadrant()) {
      std::fill_n(links.begin() + static_cast<std::ptrdiff_t>(next), 4,
                  static_cast<std::uint32_t>(i));
      next = link_cell(points, next, half / 2, links);
    }
  }
  return next;
}

}  // namespace

std::vector<std::uint32_t> course::refined_samples(const std::vector<glm::dvec2>& points) {
  std::vector<std::uint32_t> links(points.size(), no_index);
  link_cell(points, 0, 0.5, links);
  return links;
}

}  // namespace scenefile
