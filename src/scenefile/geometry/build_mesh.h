#pragma once
// Shared by both tessellations of shapes. Internal to geometry.

#include "scenefile/geometry/mesh.h"

namespace scenefile {

/// The index of the new position.
inline std::uint32_t add_position(Mesh& mesh, const glm::dvec3& position) {
  mesh.positions.emplace_back(position);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

}  // namespace scenefile
