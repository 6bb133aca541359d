#include "scenefile/scene/prepare.h"

#include <cmath>
#include <numbers>

namespace scenefile {

namespace {

bool usable(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length);
}

// A unit vector perpendicular to w, for cameras whose `up` does not define one.
glm::dvec3 across(const glm::dvec3& w) {
  const glm::dvec3 axis = std::abs(w.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  return glm::normalize(axis - glm::dot(axis, w) * w);
}

}  // namespace

RenderCamera ready_camera(const Camera& camera) {
  const glm::dvec3 look(camera.look);
  const glm::dvec3 up(camera.up);
  RenderCamera ready;
  ready.position = glm::dvec3(camera.position);
  ready.w = -glm::normalize(usable(look) ? look : glm::dvec3(Camera{}.look));
  const glm::dvec3 v = up - glm::dot(up, ready.w) * ready.w;
  ready.v = usable(v) ? glm::normalize(v) : across(ready.w);
  ready.u = glm::cross(ready.v, ready.w);
  const double angle = camera.height_angle_deg;
  ready.fov_y = (angle > 0 && angle < 180 ? angle : 45) * std::numbers::pi / 180;
  ready.aperture = camera.aperture > 0 ? camera.aperture : 0;
  ready.focal_length = camera.focal_length > 0 ? camera.focal_length : 0;
  return ready;
}

}  // namespace scenefile
