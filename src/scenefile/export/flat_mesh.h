#pragma once
// Meshes as graphics hardware and glTF want them: one index for all values of a corner. Private to
// the room.

#include "scenefile/geometry/mesh.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace scenefile {

struct FlatMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;  ///< unit length, or empty: shaded flat
  std::vector<glm::vec2> uvs;      ///< v up; empty, or one each
  std::vector<std::uint32_t> indices;
};

/// Triangles without normals take the geometric one where others have some.
FlatMesh flatten(const Mesh& mesh);

}  // namespace scenefile
