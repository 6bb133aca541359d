#include "scenefile/trace/footprint.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

// Below this share of grazing light the footprint grows no further.
constexpr double min_cosine = 1.0 / 64;

// (du, dv) of a step on the surface, by the tangents (both in world space).
glm::dvec2 uv_step(const glm::dvec3& tangent_u, const glm::dvec3& tangent_v,
                   const glm::dvec3& step) {
  const glm::dvec3 area = glm::cross(tangent_u, tangent_v);
  const double squared = glm::dot(area, area);
  if (!(squared > 1e-30 * glm::dot(tangent_u, tangent_u) * glm::dot(tangent_v, tangent_v))) {
    return {1, 0};  // a pole: all of u meets there
  }
  return {glm::dot(glm::cross(step, tangent_v), area) / squared,
          glm::dot(glm::cross(tangent_u, step), area) / squared};
}

// The two axes of the surface under the ray: along its slant, and across.
void surface_axes(const glm::dvec3& normal, const glm::dvec3& direction, glm::dvec3& along,
                  glm::dvec3& across) {
  along = direction - glm::dot(direction, normal) * normal;
  const double length = glm::length(along);
  if (length > 1e-9) {
    along /= length;
  } else {
    const bool x_is_best = std::abs(normal.x) < 0.5;
    along =
        glm::normalize(glm::cross(normal, x_is_best ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  }
  across = glm::cross(normal, along);
}

}  // namespace

UvFootprint uv_footprint(const SurfacePoint& point, const glm::dvec3& direction, double width) {
  if (!point.has_uv) {
    return {};
  }
  const glm::dmat3 world_from_object = glm::inverse(point.hit.object_from_world.linear);
  const glm::dvec3 tangent_u = world_from_object * point.object.tangent_u;
  const glm::dvec3 tangent_v = world_from_object * point.object.tangent_v;
  glm::dvec3 along;
  glm::dvec3 across;
  surface_axes(point.geometric, direction, along, across);
  const double cosine = std::max(std::abs(glm::dot(point.geometric, direction)), min_cosine);
  return {uv_step(tangent_u, tangent_v, (width / cosine) * along),
          uv_step(tangent_u, tangent_v, width * across)};
}

RayCone bent_cone(const SurfacePoint& point, const RayCone& cone, double t, double turning) {
  RayCone bent{cone.width_at(t), cone.spread};
  if (point.hit.shape == Shape::mesh || point.hit.shape == Shape::cube ||
      point.hit.face != Face::side) {
    return bent;
  }
  // How fast the normal turns along the surface, by looking a little aside.
  const glm::dmat3 world_from_object = glm::inverse(point.hit.object_from_world.linear);
  const double step = 1e-4;
  for (const glm::dvec3& tangent : {point.object.tangent_u, point.object.tangent_v}) {
    const double length = glm::length(tangent);
    if (!(length > 0)) {
      continue;
    }
    const glm::dvec3 aside = (step / length) * tangent;
    const Surface beside =
        surface_at(point.hit.shape, point.hit.face, point.hit.object_point + aside);
    const double turn =
        glm::length(world_normal(point.hit.object_from_world, beside.normal) - point.geometric);
    const double way = glm::length(world_from_object * aside);
    bent.spread = std::max(bent.spread, cone.spread + turning * bent.width * turn / way);
  }
  return bent;
}

}  // namespace scenefile
