#pragma once
// Intersection of rays with single triangles of a mesh.

#include "scenefile/trace/scene_geometry.h"

#include <cmath>

namespace scenefile {

/// The index in the mesh of a primitive of its scene.
inline std::uint32_t triangle_of(const MeshScene& mesh, std::uint32_t primitive) {
  return mesh.triangles.empty() ? primitive : mesh.triangles[primitive];
}

struct TriangleHit {
  double t = 0;
  double b1 = 0;  ///< barycentric weight of the second corner
  double b2 = 0;  ///< the same for the third corner
};

/// The hit on the triangle's plane; the search has already found it to be inside. Weights are
/// clamped because the two computations can disagree at edges.
inline bool meet_triangle(const Mesh& mesh, std::uint32_t index, const Ray& ray, TriangleHit& hit) {
  const auto& corners = mesh.triangles[index];
  const glm::dvec3 p0(mesh.positions[corners[0]]);
  const glm::dvec3 e1 = glm::dvec3(mesh.positions[corners[1]]) - p0;
  const glm::dvec3 e2 = glm::dvec3(mesh.positions[corners[2]]) - p0;
  const glm::dvec3 normal = glm::cross(e1, e2);
  const double facing = glm::dot(normal, ray.direction);
  hit.t = glm::dot(normal, p0 - ray.origin) / facing;
  if (!std::isfinite(hit.t)) {
    return false;
  }
  const glm::dvec3 q = glm::cross(p0 - ray.origin, ray.direction);
  hit.b1 = glm::clamp(glm::dot(q, e2) / facing, 0.0, 1.0);
  hit.b2 = glm::clamp(-glm::dot(q, e1) / facing, 0.0, 1.0 - hit.b1);
  return true;
}

}  // namespace scenefile
