#pragma once
// Triangles in the form that the shaders use. Internal to view.

#include "scenefile/base/shape.h"
#include "scenefile/geometry/mesh.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace scenefile {

/// A vertex, in object space.
struct DrawVertex {
  glm::vec3 position{0};
  glm::vec3 normal{0};
  /// 1: on a round side; the fragment shader recomputes normal and uv from the position.
  float round = 0;
  glm::vec2 uv{0};
};

struct DrawVertices {
  std::vector<DrawVertex> vertices;
  std::vector<std::uint32_t> triangles;  ///< three indices each
};

/// Vertices of an analytic shape. Round outlines lie equally outside and inside of the exact
/// surface: each polygon has the area of its circle.
DrawVertices shape_vertices(Shape shape, int segments);

/// Vertices of a mesh, without duplicates. `smooth`: uses the file's normals, if any.
DrawVertices mesh_vertices(const Mesh& mesh, bool smooth);

/// Each edge of the triangles once, two indices each.
std::vector<std::uint32_t> edges(const std::vector<std::uint32_t>& triangles);

/// The edges where the surface bends or ends, each once: not those inside flat faces.
std::vector<std::uint32_t> bent_edges(const DrawVertices& data);

}  // namespace scenefile
