#pragma once
// Triangle meshes: plain data.

#include "scenefile/geometry/shapes.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace scenefile {

/// A triangle mesh in its own space. Normals and uvs, where present, have an index list of their
/// own because files index them apart; a triangle without them has mesh_no_index there.
struct Mesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;  ///< any length but zero
  std::vector<glm::vec2> uvs;
  std::vector<std::array<std::uint32_t, 3>> triangles;         ///< into positions; all valid
  std::vector<std::array<std::uint32_t, 3>> triangle_normals;  ///< empty, or one per triangle
  std::vector<std::array<std::uint32_t, 3>> triangle_uvs;      ///< empty, or one per triangle
};

inline constexpr std::uint32_t mesh_no_index = 0xffffffffu;

/// The surface of triangle `index` at barycentric weights (1-b1-b2, b1, b2) of its corners:
/// geometric normal by the counterclockwise order of the corners when `smooth` is false or the
/// triangle has no normals, else the interpolated one. uv is (0, 0) where the mesh has none.
Surface surface_at(const Mesh& mesh, std::uint32_t index, double b1, double b2, bool smooth);

Bounds bounds(const Mesh& mesh);

}  // namespace scenefile
