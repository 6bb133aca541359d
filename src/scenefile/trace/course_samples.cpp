#include "scenefile/trace/course_samples.h"

#include "scenefile/trace/integrator.h"

#include <algorithm>

namespace scenefile {

namespace {

Color lens_pixel(const Tracer& tracer, const CameraRays& camera, const glm::dvec2& center,
                 RayCounts& counts) {
  Color sum(0);
  for (const auto& [u, v] : course::lens_points) {
    sum += trace_sample(tracer, camera, {center, {u, v}, {}, {}}, counts);
  }
  return sum / double(course::lens_points.size());
}

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

Color course_pixel(const Tracer& tracer, const CameraRays& camera, int x, int y,
                   RayCounts& counts) {
  const glm::dvec2 corner(x, y);
  const auto color_at = [&](const glm::dvec2& point) {
    return trace_sample(tracer, camera, {point, {}, {}, {}}, counts);
  };
  if (camera.has_lens()) {
    return lens_pixel(tracer, camera, corner + 0.5, counts);
  }
  return tracer.options.features.super_sample ? course::cell(color_at, corner, 1, 1)
                                              : color_at(corner + 0.5);
}

}  // namespace scenefile
