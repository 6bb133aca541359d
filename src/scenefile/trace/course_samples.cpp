#include "scenefile/trace/course_samples.h"

#include "scenefile/trace/integrator.h"

namespace scenefile {

namespace {

Color lens_pixel(const Tracer& tracer, const CameraRays& camera, const glm::dvec2& center,
                 RayCounts& counts) {
  Color sum(0);
  for (const auto& [u, v] : course::lens_points) {
    sum += trace_sample(tracer, camera, center, {u, v}, {}, {}, counts);
  }
  return sum / double(course::lens_points.size());
}

}  // namespace

Color course_pixel(const Tracer& tracer, const CameraRays& camera, int x, int y,
                   RayCounts& counts) {
  const glm::dvec2 corner(x, y);
  const auto color_at = [&](const glm::dvec2& point) {
    return trace_sample(tracer, camera, point, {0, 0}, {}, {}, counts);
  };
  if (camera.has_lens()) {
    return lens_pixel(tracer, camera, corner + 0.5, counts);
  }
  return tracer.options.features.super_sample ? course::cell(color_at, corner, 1, 1)
                                              : color_at(corner + 0.5);
}

}  // namespace scenefile
