#include "scenefile/geometry/tessellate.h"

#include "scenefile/geometry/build_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scenefile {

namespace {

using glm::dvec2;
using glm::dvec3;

using std::numbers::pi;

struct Vertex {
  std::uint32_t position;
  std::uint32_t normal;
  std::uint32_t uv;
};

Vertex add_vertex(Mesh& mesh, std::uint32_t position, const dvec3& normal, const dvec2& uv) {
  mesh.normals.emplace_back(normal);
  mesh.uvs.emplace_back(uv);
  const auto last = static_cast<std::uint32_t>(mesh.normals.size() - 1);
  return {position, last, last};
}

void add_triangle(Mesh& mesh, const Vertex& a, const Vertex& b, const Vertex& c) {
  mesh.triangles.push_back({a.position, b.position, c.position});
  mesh.triangle_normals.push_back({a.normal, b.normal, c.normal});
  mesh.triangle_uvs.push_back({a.uv, b.uv, c.uv});
}

void add_quad(Mesh& mesh, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
  add_triangle(mesh, a, b, c);
  add_triangle(mesh, a, c, d);
}

// The direction at the angle phi of a column; u = column / segments decreases with phi. Exact at
// the quadrants, so that the shape touches its bounding box.
dvec2 direction(int column, int segments) {
  const int quarter = 4 * column;
  if (quarter % segments == 0) {
    const dvec2 exact[4] = {{1, 0}, {0, -1}, {-1, 0}, {0, 1}};
    return exact[quarter / segments % 4];
  }
  const double phi = -2 * pi * column / segments;
  return {std::cos(phi), std::sin(phi)};
}

// A circle of a round side: its shared positions, and its vertices (one more, for the seam).
struct Ring {
  std::vector<std::uint32_t> positions;
  std::vector<Vertex> vertices;
};

Ring add_ring(Mesh& mesh, Shape shape, double radius, double y, int segments) {
  Ring ring;
  for (int column = 0; column <= segments; ++column) {
    const dvec2 at = radius * direction(column, segments);
    const dvec3 point(at.x, y, at.y);
    if (column < segments) {
      ring.positions.push_back(add_position(mesh, point));
    }
    const Surface surface = surface_at(shape, Face::side, point);
    const dvec2 uv(static_cast<double>(column) / segments, surface.uv.y);
    ring.vertices.push_back(
        add_vertex(mesh, ring.positions[column % segments], surface.normal, uv));
  }
  return ring;
}

// Seen from outside, u increases to the right, so the order lower left, lower right, upper right,
// upper left is counterclockwise.
void add_band(Mesh& mesh, const Ring& lower, const Ring& upper) {
  for (std::size_t i = 0; i + 1 < lower.vertices.size(); ++i) {
    add_quad(mesh, lower.vertices[i], lower.vertices[i + 1], upper.vertices[i + 1],
             upper.vertices[i]);
  }
}

// Triangles from a ring to a point on the axis, each with a separate vertex there.
void add_tip(Mesh& mesh, Shape shape, const Ring& ring, double y, bool above) {
  const std::uint32_t tip = add_position(mesh, dvec3(0, y, 0));
  const std::size_t segments = ring.positions.size();
  for (std::size_t i = 0; i < segments; ++i) {
    const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(segments);
    const dvec3 outward(std::cos(-2 * pi * u), 0, std::sin(-2 * pi * u));
    const dvec3 normal =
        surface_at(shape, Face::side, shape == Shape::cone ? outward : dvec3(0, y, 0)).normal;
    const Vertex vertex = add_vertex(mesh, tip, normal, dvec2(u, above ? 1 : 0));
    if (above) {
      add_triangle(mesh, ring.vertices[i], ring.vertices[i + 1], vertex);
    } else {
      add_triangle(mesh, ring.vertices[i + 1], ring.vertices[i], vertex);
    }
  }
}

void add_cap(Mesh& mesh, Shape shape, Face face, const std::vector<std::uint32_t>& rim) {
  const auto vertex = [&](std::uint32_t position) {
    const Surface surface = surface_at(shape, face, dvec3(mesh.positions[position]));
    return add_vertex(mesh, position, surface.normal, surface.uv);
  };
  const Vertex center = vertex(add_position(mesh, dvec3(0, face == Face::top ? 0.5 : -0.5, 0)));
  std::vector<Vertex> edge;
  for (const std::uint32_t position : rim) {
    edge.push_back(vertex(position));
  }
  for (std::size_t i = 0; i < edge.size(); ++i) {
    const Vertex& next = edge[(i + 1) % edge.size()];
    if (face == Face::top) {
      add_triangle(mesh, center, edge[i], next);
    } else {
      add_triangle(mesh, center, next, edge[i]);
    }
  }
}

Mesh tessellate_cube() {
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    add_position(mesh, dvec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1) - 0.5);
  }
  const struct {
    Face face;
    std::array<std::uint32_t, 4> corners;  // counterclockwise from outside
  } sides[] = {{Face::pos_x, {5, 1, 3, 7}}, {Face::neg_x, {0, 4, 6, 2}},
               {Face::pos_y, {6, 7, 3, 2}}, {Face::neg_y, {0, 1, 5, 4}},
               {Face::pos_z, {4, 5, 7, 6}}, {Face::neg_z, {1, 0, 2, 3}}};
  for (const auto& side : sides) {
    std::array<Vertex, 4> v{};
    for (int i = 0; i < 4; ++i) {
      const std::uint32_t position = side.corners[i];
      const Surface s = surface_at(Shape::cube, side.face, dvec3(mesh.positions[position]));
      v[i] = add_vertex(mesh, position, s.normal, s.uv);
    }
    add_quad(mesh, v[0], v[1], v[2], v[3]);
  }
  return mesh;
}

Mesh tessellate_sphere(int segments) {
  Mesh mesh;
  const int rows = std::max(2, segments / 2);
  std::vector<Ring> rings;
  for (int row = 1; row < rows; ++row) {
    const double latitude = pi * (static_cast<double>(row) / rows - 0.5);
    const double y = 2 * row == rows ? 0 : 0.5 * std::sin(latitude);
    rings.push_back(add_ring(mesh, Shape::sphere, 0.5 * std::cos(latitude), y, segments));
  }
  add_tip(mesh, Shape::sphere, rings.front(), -0.5, false);
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    add_band(mesh, rings[i], rings[i + 1]);
  }
  add_tip(mesh, Shape::sphere, rings.back(), 0.5, true);
  return mesh;
}

Mesh tessellate_cylinder(int segments) {
  Mesh mesh;
  const Ring low = add_ring(mesh, Shape::cylinder, 0.5, -0.5, segments);
  const Ring high = add_ring(mesh, Shape::cylinder, 0.5, 0.5, segments);
  add_band(mesh, low, high);
  add_cap(mesh, Shape::cylinder, Face::bottom, low.positions);
  add_cap(mesh, Shape::cylinder, Face::top, high.positions);
  return mesh;
}

// Several rows, because interpolation distorts textures in the triangles at the apex.
Mesh tessellate_cone(int segments) {
  Mesh mesh;
  const int rows = std::max(1, segments / 4);
  Ring below = add_ring(mesh, Shape::cone, 0.5, -0.5, segments);
  const std::vector<std::uint32_t> rim = below.positions;
  for (int row = 1; row < rows; ++row) {
    const double height = static_cast<double>(row) / rows;
    Ring above = add_ring(mesh, Shape::cone, 0.5 * (1 - height), height - 0.5, segments);
    add_band(mesh, below, above);
    below = std::move(above);
  }
  add_tip(mesh, Shape::cone, below, 0.5, true);
  add_cap(mesh, Shape::cone, Face::bottom, rim);
  return mesh;
}

}  // namespace

Mesh tessellate(Shape shape, int segments) {
  segments = std::clamp(segments, 3, 1024);
  switch (shape) {
    case Shape::cube:
      return tessellate_cube();
    case Shape::sphere:
      return tessellate_sphere(segments);
    case Shape::cylinder:
      return tessellate_cylinder(segments);
    case Shape::cone:
      return tessellate_cone(segments);
    case Shape::mesh:
      break;
  }
  return {};
}

}  // namespace scenefile
