#pragma once
// A hit in world space, for shading.

#include "scenefile/trace/accelerator.h"

namespace scenefile {

struct SurfacePoint {
  glm::dvec3 position{0};
  glm::dvec3 normal{0, 1, 0};     ///< for shading, unit length, outward; never flipped
  glm::dvec3 geometric{0, 1, 0};  ///< of the geometry; on meshes `normal` may be interpolated
  Surface object;                 ///< in object space
  bool has_uv = true;             ///< false for meshes without
  const RenderMaterial* material = nullptr;
  Hit hit;
};

/// `smooth`: interpolates the normals of meshes that have them.
SurfacePoint surface_point(const RenderScene& scene, const Assets& assets, const Ray& ray,
                           const Hit& hit, bool smooth);

/// Transforms an object-space normal to world space; unit length.
glm::dvec3 world_normal(const DAffine& object_from_world, const glm::dvec3& normal);

}  // namespace scenefile
