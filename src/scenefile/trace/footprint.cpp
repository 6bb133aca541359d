#include "scenefile/trace/footprint.h"

#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/geometry/surface-inl.h"
#include "scenefile/trace/camera-inl.h"
#include "scenefile/trace/footprint-inl.h"

namespace scenefile {

namespace {

using one::splat3;

glm::dvec3 vector_of(const one::V3& v) {
  return {v.x, v.y, v.z};
}

PixelSteps steps_of(const one::Steps& steps) {
  return {vector_of(steps.x), vector_of(steps.y)};
}

one::Steps in_lane(const PixelSteps& steps) {
  return {splat3(steps.x), splat3(steps.y)};
}

double number_of(Shape shape) {
  return static_cast<int>(shape);
}
double number_of(Face face) {
  return static_cast<int>(face);
}

// (du, dv) for a step on the surface, from the tangents; all in object space.
one::UvStep mesh_uv_step(const glm::dvec3& tangent_u, const glm::dvec3& tangent_v,
                         const glm::dvec3& step) {
  const glm::dvec3 area = glm::cross(tangent_u, tangent_v);
  const double squared = glm::dot(area, area);
  if (!(squared > 1e-30 * glm::dot(tangent_u, tangent_u) * glm::dot(tangent_v, tangent_v))) {
    return {1, 0};
  }
  return {glm::dot(glm::cross(step, tangent_v), area) / squared,
          glm::dot(glm::cross(tangent_u, step), area) / squared};
}

glm::dvec2 uv_step(const SurfacePoint& point, const glm::dvec3& world_step) {
  const glm::dvec3 step = point.hit.object_from_world.linear * world_step;
  const one::UvStep uv =
      point.hit.shape == Shape::mesh
          ? mesh_uv_step(point.object.tangent_u, point.object.tangent_v, step)
          : one::shape_uv_step(number_of(point.hit.shape), number_of(point.hit.face),
                               splat3(point.hit.object_point), splat3(step));
  return {uv.u, uv.v};
}

}  // namespace

PixelSteps arriving_steps(const RayDifferential& ray, const glm::dvec3& direction,
                          const SurfacePoint& point) {
  return steps_of(one::arriving_steps(in_lane(ray.origin), in_lane(ray.direction),
                                      splat3(direction), splat3(point.geometric), point.hit.t));
}

UvFootprint uv_footprint(const SurfacePoint& point, const PixelSteps& steps) {
  if (!point.has_uv) {
    return {};
  }
  return {uv_step(point, steps.x), uv_step(point, steps.y)};
}

PixelSteps normal_turns(const SurfacePoint& point, const PixelSteps& steps) {
  const glm::dmat3& map = point.hit.object_from_world.linear;
  const auto turn = [&](const glm::dvec3& step) {
    return vector_of(one::world_normal_turn(splat3(map[0]), splat3(map[1]), splat3(map[2]),
                                            number_of(point.hit.shape), number_of(point.hit.face),
                                            splat3(point.hit.object_point),
                                            splat3(point.object.normal), splat3(step)));
  };
  return {turn(steps.x), turn(steps.y)};
}

}  // namespace scenefile
