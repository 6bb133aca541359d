#pragma once
// Triangle meshes: plain data.

#include "scenefile/geometry/shapes.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace scenefile {

/// A triangle mesh in its own space. Normals and uvs, where present, have an index list of their
/// own because files index them apart; a triangle without them has mesh_no_index in all three
/// places of that list.
struct Mesh {
  std::vector<glm::vec3> positions;  ///< all finite; some may belong to no triangle
  std::vector<glm::vec3> normals;    ///< any length but zero where a triangle uses them
  std::vector<glm::vec2> uvs;        ///< v up; any value, textures repeat
  std::vector<std::array<std::uint32_t, 3>> triangles;         ///< into positions; all valid
  std::vector<std::array<std::uint32_t, 3>> triangle_normals;  ///< empty, or one per triangle
  std::vector<std::array<std::uint32_t, 3>> triangle_uvs;      ///< empty, or one per triangle
};

inline constexpr std::uint32_t mesh_no_index = 0xffffffffu;

/// The surface of triangle `index` at barycentric weights (1-b1-b2, b1, b2) of its corners. The
/// normal is the geometric one, by the counterclockwise order of the corners, when `smooth` is
/// false or the triangle has no normals; else the directions of the corners' normals, interpolated.
/// Without uvs, uv is (0, 0) and the tangents are zero; they are zero too where the uvs span no
/// area.
Surface surface_at(const Mesh& mesh, std::uint32_t index, double b1, double b2, bool smooth);

/// The triangles that a ray can meet, by index in rising order: without those of which two corners
/// are at one place, and of those with the same corners in the same order only the last.
std::vector<std::uint32_t> distinct_triangles(const Mesh& mesh);

/// The box around the triangles.
Bounds bounds(const Mesh& mesh);

}  // namespace scenefile
