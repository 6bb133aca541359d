#include "scenefile/trace/surface_point.h"

#include <cmath>

namespace scenefile {

glm::dvec3 world_normal(const DAffine& object_from_world, const glm::dvec3& normal) {
  const glm::dvec3 n = transform_normal(object_from_world, normal);
  const double length = glm::length(n);
  return length > 0 && std::isfinite(length) ? n / length : glm::dvec3(0, 1, 0);
}

SurfacePoint surface_point(const RenderScene& scene, const Assets& assets, const Ray& ray,
                           const Hit& hit, bool smooth) {
  SurfacePoint point;
  point.hit = hit;
  point.material = &scene.materials[hit.material];
  point.position = ray.origin + hit.t * ray.direction;
  const Mesh* const mesh = hit.shape == Shape::mesh ? &assets.meshes[hit.mesh] : nullptr;
  point.object = mesh == nullptr ? surface_at(hit.shape, hit.face, hit.object_point)
                                 : surface_at(*mesh, hit.triangle, hit.b1, hit.b2, smooth);
  point.has_uv = mesh == nullptr || !mesh->triangle_uvs.empty();
  point.normal = world_normal(hit.object_from_world, point.object.normal);
  point.geometric = point.object.flat == point.object.normal
                        ? point.normal
                        : world_normal(hit.object_from_world, point.object.flat);
  return point;
}

}  // namespace scenefile
