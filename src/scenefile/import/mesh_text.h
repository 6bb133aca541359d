#pragma once
// Triangles as the text of an OBJ file. Internal to import.

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace scenefile {

/// Vertices with their attributes; normals and uvs (v up) are empty or one per vertex.
struct TriangleList {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> uvs;
  std::vector<std::uint32_t> indices;  ///< three per triangle, all valid
};

std::string obj_text(const TriangleList& list);

}  // namespace scenefile
