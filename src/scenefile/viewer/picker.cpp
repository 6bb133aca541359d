#include "scenefile/viewer/picker.h"

#include <algorithm>
#include <cmath>

namespace scenefile::viewer {

namespace {

bool is_drawn(const Hit& hit, const Ray& ray, const PickPlanes& planes) {
  const double depth = hit.t * glm::dot(ray.direction, planes.forward);
  if (depth < planes.near || depth > planes.far) {
    return false;
  }
  if (hit.shape == Shape::mesh) {
    return true;  // which side is visible depends on the file
  }
  // A reflecting transform shows the inside, as in OpenGL.
  const glm::dmat3& matrix = hit.object_from_world.linear;
  const double toward =
      glm::dot(surface_at(hit.shape, hit.face, hit.object_point).normal, matrix * ray.direction);
  return glm::determinant(matrix) > 0 ? toward < 0 : toward > 0;
}

}  // namespace

Ray ray_through(const RenderCamera& camera, const glm::dvec2& point, double aspect) {
  const double half = std::tan(camera.fov_y / 2);
  const glm::dvec3 direction = -camera.w + camera.u * ((2 * point.x - 1) * half * aspect) +
                               camera.v * ((1 - 2 * point.y) * half);
  return {camera.position, glm::normalize(direction)};
}

std::optional<Pick> Picker::pick(const Ray& ray, const Hidden& hidden,
                                 const std::optional<PickPlanes>& planes) const {
  constexpr int max_hidden = 64;  // one behind another along the ray
  if (accelerator_.status() != AcceleratorStatus::ready) {
    return std::nullopt;
  }
  double from = 0;
  Hit hit;
  for (int i = 0; i < max_hidden && accelerator_.closest(ray, from, 1e300, hit); ++i) {
    Pick pick;
    pick.source = hit.source;
    pick.instances = accelerator_.instances_of_closest(ray, from, 1e300);
    pick.distance = hit.t;
    pick.point = ray.origin + ray.direction * hit.t;
    const bool is_hidden =
        hidden.contains(pick.source) ||
        std::any_of(pick.instances.begin(), pick.instances.end(),
                    [&](std::uint32_t source) { return hidden.contains(source); });
    if (!is_hidden && (!planes || is_drawn(hit, ray, *planes))) {
      return pick;
    }
    from = hit.t + 1e-7 * std::max(1.0, hit.t);
  }
  return std::nullopt;
}

}  // namespace scenefile::viewer
