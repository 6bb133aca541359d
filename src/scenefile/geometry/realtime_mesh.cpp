#include "scenefile/geometry/realtime_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace scenefile {

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double pi = 3.14159265358979323846;

struct Vertex {
  std::uint32_t position;
  std::uint32_t normal;
};

std::uint32_t add_position(Mesh& mesh, const dvec3& p) {
  mesh.positions.emplace_back(p);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

std::uint32_t add_normal(Mesh& mesh, const dvec3& n) {
  mesh.normals.emplace_back(n);
  return static_cast<std::uint32_t>(mesh.normals.size() - 1);
}

// Skips degenerate triangles, as in quads with two equal corners.
void add_triangle(Mesh& mesh, const Vertex& a, const Vertex& b, const Vertex& c) {
  if (a.position != b.position && b.position != c.position && c.position != a.position) {
    mesh.triangles.push_back({a.position, b.position, c.position});
    mesh.triangle_normals.push_back({a.normal, b.normal, c.normal});
  }
}

void add_quad(Mesh& mesh, const Vertex& upper_left, const Vertex& lower_left,
              const Vertex& lower_right, const Vertex& upper_right) {
  add_triangle(mesh, upper_left, lower_left, lower_right);
  add_triangle(mesh, upper_left, lower_right, upper_right);
}

// The outward direction at a fraction of a turn from the x axis toward -z.
dvec2 outward(double turn) {
  return {std::cos(2 * pi * turn), -std::sin(2 * pi * turn)};
}

// The vertices at one height of a round shape, one for each wedge.
using Ring = std::vector<Vertex>;

// Seen from outside, wedges proceed to the right.
void add_band(Mesh& mesh, const Ring& upper, const Ring& lower) {
  for (std::size_t j = 0; j < upper.size(); ++j) {
    const std::size_t next = (j + 1) % upper.size();
    add_quad(mesh, upper[j], lower[j], lower[next], upper[next]);
  }
}

Ring with_normal(Ring ring, std::uint32_t normal) {
  for (Vertex& vertex : ring) {
    vertex.normal = normal;
  }
  return ring;
}

std::vector<std::uint32_t> add_circle(Mesh& mesh, double radius, double y, int wedges) {
  std::vector<std::uint32_t> positions;
  for (int j = 0; j < wedges; ++j) {
    const dvec2 at = radius * outward(double(j) / wedges);
    positions.push_back(add_position(mesh, {at.x, y, at.y}));
  }
  return positions;
}

// A disk of rings about the y axis, from its rim to its center; `normal_y` is 1 or -1.
void add_cap(Mesh& mesh, const Ring& rim, double y, int rings, double normal_y) {
  const std::uint32_t normal = add_normal(mesh, {0, normal_y, 0});
  const auto wedges = static_cast<int>(rim.size());
  Ring outer = with_normal(rim, normal);
  for (int i = rings - 1; i >= 0; --i) {
    Ring inner;
    if (i == 0) {
      inner.assign(rim.size(), Vertex{add_position(mesh, {0, y, 0}), normal});
    } else {
      for (const std::uint32_t p : add_circle(mesh, 0.5 * i / rings, y, wedges)) {
        inner.push_back({p, normal});
      }
    }
    add_band(mesh, normal_y > 0 ? inner : outer, normal_y > 0 ? outer : inner);
    outer = std::move(inner);
  }
}

Mesh make_cube(int tiles) {
  Mesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> known;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      dvec3 direction(0);
      direction[axis] = side;
      const std::uint32_t normal = add_normal(mesh, direction);
      // Up, seen from outside: y on the four walls, -z on the top, z on the bottom.
      const dvec3 up = axis == 1 ? dvec3(0, 0, -side) : dvec3(0, 1, 0);
      const dvec3 right = glm::cross(up, direction);
      const auto vertex = [&](int row, int column) {
        const dvec3 grid = double(tiles) * direction + double(2 * column - tiles) * right +
                           double(tiles - 2 * row) * up;
        const std::array<int, 3> key{int(grid.x), int(grid.y), int(grid.z)};
        const auto [found, fresh] = known.try_emplace(key, 0);
        if (fresh) {
          found->second = add_position(mesh, grid / (2.0 * tiles));
        }
        return Vertex{found->second, normal};
      };
      for (int row = 0; row < tiles; ++row) {
        for (int column = 0; column < tiles; ++column) {
          add_quad(mesh, vertex(row, column), vertex(row + 1, column), vertex(row + 1, column + 1),
                   vertex(row, column + 1));
        }
      }
    }
  }
  return mesh;
}

Mesh make_sphere(int rings, int wedges) {
  Mesh mesh;
  const auto pole = [&](double y) {
    return Ring(std::size_t(wedges),
                {add_position(mesh, {0, 0.5 * y, 0}), add_normal(mesh, {0, y, 0})});
  };
  Ring upper = pole(1);
  for (int i = 1; i < rings; ++i) {
    const double phi = pi * i / rings;
    Ring lower;
    for (const std::uint32_t p :
         add_circle(mesh, 0.5 * std::sin(phi), 0.5 * std::cos(phi), wedges)) {
      lower.push_back({p, add_normal(mesh, glm::normalize(dvec3(mesh.positions[p])))});
    }
    add_band(mesh, upper, lower);
    upper = std::move(lower);
  }
  add_band(mesh, upper, pole(-1));
  return mesh;
}

Mesh make_cylinder(int stacks, int wedges) {
  Mesh mesh;
  std::vector<std::uint32_t> normals;
  for (int j = 0; j < wedges; ++j) {
    const dvec2 out = outward(double(j) / wedges);
    normals.push_back(add_normal(mesh, {out.x, 0, out.y}));
  }
  const auto ring = [&](int stack) {
    Ring result;
    const auto positions = add_circle(mesh, 0.5, 0.5 - double(stack) / stacks, wedges);
    for (std::size_t j = 0; j < positions.size(); ++j) {
      result.push_back({positions[j], normals[j]});
    }
    return result;
  };
  Ring upper = ring(0);
  add_cap(mesh, upper, 0.5, stacks, 1);
  for (int i = 1; i <= stacks; ++i) {
    Ring lower = ring(i);
    add_band(mesh, upper, lower);
    upper = std::move(lower);
  }
  add_cap(mesh, upper, -0.5, stacks, -1);
  return mesh;
}

Mesh make_cone(int stacks, int wedges) {
  Mesh mesh;
  const auto side_normal = [&](double wedge) {
    const dvec2 out = outward(wedge / wedges);
    return add_normal(mesh, glm::normalize(dvec3(2 * out.x, 1, 2 * out.y)));
  };
  const std::uint32_t tip = add_position(mesh, {0, 0.5, 0});
  std::vector<std::uint32_t> normals;
  Ring upper;
  for (int j = 0; j < wedges; ++j) {
    upper.push_back({tip, side_normal(j + 0.5)});
    normals.push_back(side_normal(j));
  }
  for (int i = 1; i <= stacks; ++i) {
    Ring lower;
    const double down = double(i) / stacks;
    const auto positions = add_circle(mesh, 0.5 * down, 0.5 - down, wedges);
    for (std::size_t j = 0; j < positions.size(); ++j) {
      lower.push_back({positions[j], normals[j]});
    }
    add_band(mesh, upper, lower);
    upper = std::move(lower);
  }
  add_cap(mesh, upper, -0.5, stacks, -1);
  return mesh;
}

}  // namespace

Mesh realtime_mesh(Shape shape, const TessellationParameters& parameters) {
  const int p1 = std::clamp(parameters.parameter1, 1, most_tessellation);
  const int wedges = std::clamp(parameters.parameter2, 3, most_tessellation);
  switch (shape) {
    case Shape::cube:
      return make_cube(p1);
    case Shape::sphere:
      return make_sphere(std::max(2, p1), wedges);
    case Shape::cylinder:
      return make_cylinder(p1, wedges);
    case Shape::cone:
      return make_cone(p1, wedges);
    case Shape::mesh:
      break;
  }
  return {};
}

}  // namespace scenefile
