#pragma once
// Triangles as the shaders take them. Internal to the room.

#include "scenefile/base/shape.h"
#include "scenefile/geometry/mesh.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace scenefile {

/// One corner, in object space.
struct DrawVertex {
  glm::vec3 position{0};
  glm::vec3 normal{0};
  /// 1: on a round side, whose normal and uv the fragment shader finds anew from the position.
  float round = 0;
  glm::vec2 uv{0};
};

struct DrawVertices {
  std::vector<DrawVertex> vertices;
  std::vector<std::uint32_t> triangles;  ///< indices, three each
};

/// Of an analytic shape. Round outlines are as much outside of the exact surface as inside: the
/// area of a circle is that of its polygon.
DrawVertices shape_vertices(Shape shape, int segments);

/// Of a mesh; corners that are equal in everything are one vertex. `smooth`: with the normals of
/// the file, where it has them.
DrawVertices mesh_vertices(const Mesh& mesh, bool smooth);

/// Each edge of the triangles once, two indices each.
std::vector<std::uint32_t> edges(const std::vector<std::uint32_t>& triangles);

/// The edges at which the surface bends or ends, once each: not those inside of flat faces.
std::vector<std::uint32_t> bent_edges(const DrawVertices& data);

}  // namespace scenefile
