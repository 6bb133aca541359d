#pragma once
// Meshes as graphics hardware and glTF expect them: one index for all attributes of a vertex.
// Internal to export.

#include "scenefile/geometry/mesh.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace scenefile {

struct FlatMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;  ///< unit length; empty: flat shading
  std::vector<glm::vec2> uvs;      ///< v up; empty, or one per vertex
  std::vector<std::uint32_t> indices;
};

/// Triangles without normals get the geometric normal if others in the mesh have normals.
FlatMesh flatten(const Mesh& mesh);

}  // namespace scenefile
