#include "scenefile/trace/footprint.h"

#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/geometry/surface-inl.h"
#include "scenefile/trace/camera-inl.h"
#include "scenefile/trace/footprint-inl.h"

namespace scenefile {

namespace {

using one::splat3;

double number_of(Shape shape) {
  return static_cast<int>(shape);
}
double number_of(Face face) {
  return static_cast<int>(face);
}

glm::dvec2 uv_derivative(const SurfacePoint& point, const glm::dvec3& world_step) {
  const glm::dvec3 step = point.hit.object_from_world.linear * world_step;
  const one::UvDerivative uv =
      point.hit.shape == Shape::mesh
          ? one::mesh_uv_derivative(splat3(point.object.tangent_u), splat3(point.object.tangent_v),
                                    splat3(step))
          : one::shape_uv_derivative(number_of(point.hit.shape), number_of(point.hit.face),
                                     splat3(point.hit.object_point), splat3(step));
  return {uv.u, uv.v};
}

}  // namespace

UvFootprint uv_footprint(const SurfacePoint& point, const PixelDerivatives& dp) {
  if (!point.has_uv) {
    return {};
  }
  return {uv_derivative(point, dp.dx), uv_derivative(point, dp.dy)};
}

}  // namespace scenefile
