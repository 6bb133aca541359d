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

/// Where a ray meets the plane of a triangle: t, and weights that are between 0 and 1 inside it.
/// `facing` is below 0 if the ray comes from the front. False if it is parallel to the plane.
inline bool meet_plane(const Mesh& mesh, std::uint32_t index, const Ray& ray, TriangleHit& hit,
                       double& facing) {
  const auto& corners = mesh.triangles[index];
  const glm::dvec3 p0(mesh.positions[corners[0]]);
  const glm::dvec3 e1 = glm::dvec3(mesh.positions[corners[1]]) - p0;
  const glm::dvec3 e2 = glm::dvec3(mesh.positions[corners[2]]) - p0;
  const glm::dvec3 normal = glm::cross(e1, e2);
  facing = glm::dot(normal, ray.direction);
  hit.t = glm::dot(normal, p0 - ray.origin) / facing;
  const glm::dvec3 q = glm::cross(p0 - ray.origin, ray.direction);
  hit.b1 = glm::dot(q, e2) / facing;
  hit.b2 = -glm::dot(q, e1) / facing;
  return std::isfinite(hit.t);
}

/// The hit on a triangle that the search has found; weights are clamped because the two
/// computations can disagree at edges.
inline bool meet_triangle(const Mesh& mesh, std::uint32_t index, const Ray& ray, TriangleHit& hit) {
  double facing = 0;
  if (!meet_plane(mesh, index, ray, hit, facing)) {
    return false;
  }
  hit.b1 = glm::clamp(hit.b1, 0.0, 1.0);
  hit.b2 = glm::clamp(hit.b2, 0.0, 1.0 - hit.b1);
  return true;
}

}  // namespace scenefile
