#include "trace/scalar_rays.h"

#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/geometry/surface-inl.h"
#include "scenefile/trace/camera-inl.h"
#include "scenefile/trace/footprint-inl.h"
#include "scenefile/trace/optics-inl.h"

namespace scenefile {

namespace {

using one::splat3;

glm::dvec3 vector_of(const one::V3& v) {
  return {v.x, v.y, v.z};
}

PixelDerivatives derivatives_of(const one::Derivatives& d) {
  return {vector_of(d.dx), vector_of(d.dy)};
}

one::Derivatives in_lane(const PixelDerivatives& d) {
  return {splat3(d.dx), splat3(d.dy)};
}

// Derivatives of the normal, on the side of the normal `wanted`.
one::Derivatives dn_of(const SurfacePoint& point, const PixelDerivatives& dp,
                       const glm::dvec3& wanted) {
  return one::on_side(in_lane(normal_derivatives(point, dp)), splat3(point.geometric),
                      splat3(wanted));
}

}  // namespace

double start_offset(const Tracer& tracer, const glm::dvec3& point, double distance) {
  return tracer.course() ? one::course_offset : one::fine_offset(splat3(point), distance);
}

glm::dvec3 reflect_direction(const glm::dvec3& direction, const glm::dvec3& normal) {
  const one::V3 mirrored = one::mirrored(one::splat3(direction), one::splat3(normal));
  return {mirrored.x, mirrored.y, mirrored.z};
}

bool refract_direction(const glm::dvec3& direction, const glm::dvec3& normal, double eta,
                       glm::dvec3& refracted) {
  const one::Refracted found = one::refraction(one::splat3(direction), one::splat3(normal), eta);
  if (found.through) {
    refracted = {found.direction.x, found.direction.y, found.direction.z};
  }
  return found.through;
}

RayDifferential camera_differential(const CameraRays& camera, const glm::dvec2& pixel,
                                    const glm::dvec2& lens, double width) {
  return {{},
          derivatives_of(
              one::camera_derivatives(camera.frame(), pixel.x, pixel.y, lens.x, lens.y, width))};
}

PixelDerivatives hit_derivatives(const RayDifferential& ray, const glm::dvec3& direction,
                                 const SurfacePoint& point) {
  return derivatives_of(one::hit_derivatives(in_lane(ray.origin), in_lane(ray.direction),
                                             splat3(direction), splat3(point.geometric),
                                             point.hit.t));
}

PixelDerivatives normal_derivatives(const SurfacePoint& point, const PixelDerivatives& dp) {
  const glm::dmat3& map = point.hit.object_from_world.linear;
  const auto dn = [&](const glm::dvec3& step) {
    return vector_of(one::world_normal_derivative(
        splat3(map[0]), splat3(map[1]), splat3(map[2]), static_cast<int>(point.hit.shape),
        static_cast<int>(point.hit.face), splat3(point.hit.object_point),
        splat3(point.object.normal), splat3(step)));
  };
  return {dn(dp.dx), dn(dp.dy)};
}

RayDifferential mirrored_differential(const RayDifferential& ray, const glm::dvec3& direction,
                                      const SurfacePoint& point, const PixelDerivatives& dp,
                                      const glm::dvec3& normal) {
  return {dp, derivatives_of(one::mirrored_derivatives(splat3(direction), splat3(normal),
                                                       in_lane(ray.direction),
                                                       dn_of(point, dp, normal)))};
}

RayDifferential refracted_differential(const RayDifferential& ray, const glm::dvec3& direction,
                                       const SurfacePoint& point, const PixelDerivatives& dp,
                                       const glm::dvec3& normal, double eta) {
  return {dp, derivatives_of(one::refracted_derivatives(splat3(direction), splat3(normal), eta,
                                                        in_lane(ray.direction),
                                                        dn_of(point, dp, normal)))};
}

}  // namespace scenefile
