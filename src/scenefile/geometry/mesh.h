#pragma once
// Triangle meshes: plain data.

#include "scenefile/geometry/shapes.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace scenefile {

/// A triangle mesh in its own space. Normals and uvs, if present, have separate index lists because
/// files index them separately. A triangle without them has mesh_no_index in all three entries of
/// that list.
struct Mesh {
  std::vector<glm::vec3> positions;  ///< all finite; some may be unused
  std::vector<glm::vec3> normals;    ///< any length; not zero if used by a triangle
  std::vector<glm::vec2> uvs;        ///< v up; any value, textures repeat
  std::vector<std::array<std::uint32_t, 3>> triangles;         ///< into positions; all valid
  std::vector<std::array<std::uint32_t, 3>> triangle_normals;  ///< empty, or one per triangle
  std::vector<std::array<std::uint32_t, 3>> triangle_uvs;      ///< empty, or one per triangle
};

inline constexpr std::uint32_t mesh_no_index = 0xffffffffu;

/// The surface of triangle `index` at barycentric weights (1-b1-b2, b1, b2). The normal is the
/// geometric one (by counterclockwise corners) if `smooth` is false or the triangle has no normals;
/// otherwise it interpolates the directions of the corners' normals. Without uvs, uv is (0, 0) and
/// the tangents are zero; the tangents are also zero if the uvs span no area.
Surface surface_at(const Mesh& mesh, std::uint32_t index, double b1, double b2, bool smooth);

/// The triangles that a ray can hit, as ascending indices: without triangles that have two corners
/// at the same position, and of triangles with the same corners in the same order only the last.
std::vector<std::uint32_t> distinct_triangles(const Mesh& mesh);

/// The bounding box of the triangles.
Bounds bounds(const Mesh& mesh);

}  // namespace scenefile
