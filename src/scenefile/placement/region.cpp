#include "scenefile/placement/region.h"

#include "scenefile/base/shape_traits.h"

#include <cmath>
#include <numbers>

namespace scenefile {

namespace {

using std::numbers::pi;

// The half-space whose boundary contains the point.
HalfSpace through(const glm::dvec3& point, const glm::dvec3& outward) {
  return {outward, glm::dot(outward, point)};
}

// Bounds a cone by half-spaces that touch it.
void add_cone(Region& region, const glm::dvec3& apex, const glm::dvec3& axis, double half_angle) {
  constexpr int sides = 16;
  const glm::dvec3 other = std::abs(axis.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(axis, other));
  const glm::dvec3 v = glm::cross(axis, u);
  for (int i = 0; i < sides; ++i) {
    const double turn = 2 * pi * i / sides;
    const glm::dvec3 side = std::cos(turn) * u + std::sin(turn) * v;
    region.push_back(through(apex, std::cos(half_angle) * side - std::sin(half_angle) * axis));
  }
}

}  // namespace

Region view_region(const RenderCamera& camera, double aspect) {
  // A ray that starts at l from the lens's center is, at depth z, at most l + z (t + l / f) from
  // the axis.
  const bool pinhole = !(camera.aperture > 0 && camera.focal_length > 0);
  const double lens = pinhole ? 0 : camera.aperture;
  const double widening = pinhole ? 0 : camera.aperture / camera.focal_length;
  const double up = std::tan(camera.fov_y / 2) + widening;
  const double right = std::tan(camera.fov_y / 2) * aspect + widening;
  Region region{through(camera.position, camera.w),
                through(camera.position, camera.v + up * camera.w),
                through(camera.position, up * camera.w - camera.v),
                through(camera.position, camera.u + right * camera.w),
                through(camera.position, right * camera.w - camera.u)};
  for (std::size_t i = 1; i < region.size(); ++i) {
    region[i].distance += lens;
  }
  return region;
}

Region lit_region(const RenderLight& light) {
  Region region;
  const glm::dvec3 position(light.position);
  const glm::dvec3 direction(light.direction);
  if (has_rectangle(light.type)) {
    region.push_back(through(position, -direction));
  } else if (has_cone(light.type) && light.outer_angle <= pi / 2) {
    region.push_back(through(position, -direction));
    add_cone(region, position, direction, light.outer_angle);
  }
  return region;
}

}  // namespace scenefile
