#include "scenefile/geometry/realtime_mesh.h"

#include "scenefile/geometry/build_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace scenefile {

namespace {

using glm::dvec2;
using glm::dvec3;

using std::numbers::pi;

struct GridVertex {
  std::uint32_t position;
  std::uint32_t normal;
};

std::uint32_t add_normal(Mesh& mesh, const dvec3& n) {
  mesh.normals.emplace_back(n);
  return static_cast<std::uint32_t>(mesh.normals.size() - 1);
}

// Skips degenerate triangles, as in quads with two equal corners.
void add_grid_triangle(Mesh& mesh, const GridVertex& a, const GridVertex& b, const GridVertex& c) {
  if (a.position != b.position && b.position != c.position && c.position != a.position) {
    mesh.triangles.push_back({a.position, b.position, c.position});
    mesh.triangle_normals.push_back({a.normal, b.normal, c.normal});
  }
}

void add_grid_quad(Mesh& mesh, const GridVertex& upper_left, const GridVertex& lower_left,
                   const GridVertex& lower_right, const GridVertex& upper_right) {
  add_grid_triangle(mesh, upper_left, lower_left, lower_right);
  add_grid_triangle(mesh, upper_left, lower_right, upper_right);
}

// The outward direction at a fraction of a turn from the x axis toward -z.
dvec2 outward(double turn) {
  return {std::cos(2 * pi * turn), -std::sin(2 * pi * turn)};
}

// The vertices at one height of a round shape, one for each wedge.
using GridRing = std::vector<GridVertex>;

// Seen from outside, wedges proceed to the right.
void add_grid_band(Mesh& mesh, const GridRing& upper, const GridRing& lower) {
  for (std::size_t j = 0; j < upper.size(); ++j) {
    const std::size_t next = (j + 1) % upper.size();
    add_grid_quad(mesh, upper[j], lower[j], lower[next], upper[next]);
  }
}

GridRing with_normal(GridRing ring, std::uint32_t normal) {
  for (GridVertex& vertex : ring) {
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
void add_cap(Mesh& mesh, const GridRing& rim, double y, int rings, double normal_y) {
  const std::uint32_t normal = add_normal(mesh, {0, normal_y, 0});
  const auto wedges = static_cast<int>(rim.size());
  GridRing outer = with_normal(rim, normal);
  for (int i = rings - 1; i >= 0; --i) {
    GridRing inner;
    if (i == 0) {
      inner.assign(rim.size(), GridVertex{add_position(mesh, {0, y, 0}), normal});
    } else {
      for (const std::uint32_t p : add_circle(mesh, 0.5 * i / rings, y, wedges)) {
        inner.push_back({p, normal});
      }
    }
    add_grid_band(mesh, normal_y > 0 ? inner : outer, normal_y > 0 ? outer : inner);
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
        return GridVertex{found->second, normal};
      };
      for (int row = 0; row < tiles; ++row) {
        for (int column = 0; column < tiles; ++column) {
          add_grid_quad(mesh, vertex(row, column), vertex(row + 1, column),
                        vertex(row + 1, column + 1), vertex(row, column + 1));
        }
      }
    }
  }
  return mesh;
}

Mesh make_sphere(int rings, int wedges) {
  Mesh mesh;
  const auto pole = [&](double y) {
    return GridRing(std::size_t(wedges),
                    {add_position(mesh, {0, 0.5 * y, 0}), add_normal(mesh, {0, y, 0})});
  };
  GridRing upper = pole(1);
  for (int i = 1; i < rings; ++i) {
    const double phi = pi * i / rings;
    GridRing lower;
    for (const std::uint32_t p :
         add_circle(mesh, 0.5 * std::sin(phi), 0.5 * std::cos(phi), wedges)) {
      lower.push_back({p, add_normal(mesh, glm::normalize(dvec3(mesh.positions[p])))});
    }
    add_grid_band(mesh, upper, lower);
    upper = std::move(lower);
  }
  add_grid_band(mesh, upper, pole(-1));
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
    GridRing result;
    const auto positions = add_circle(mesh, 0.5, 0.5 - double(stack) / stacks, wedges);
    for (std::size_t j = 0; j < positions.size(); ++j) {
      result.push_back({positions[j], normals[j]});
    }
    return result;
  };
  GridRing upper = ring(0);
  add_cap(mesh, upper, 0.5, stacks, 1);
  for (int i = 1; i <= stacks; ++i) {
    GridRing lower = ring(i);
    add_grid_band(mesh, upper, lower);
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
  GridRing upper;
  for (int j = 0; j < wedges; ++j) {
    upper.push_back({tip, side_normal(j + 0.5)});
    normals.push_back(side_normal(j));
  }
  for (int i = 1; i <= stacks; ++i) {
    GridRing lower;
    const double down = double(i) / stacks;
    const auto positions = add_circle(mesh, 0.5 * down, 0.5 - down, wedges);
    for (std::size_t j = 0; j < positions.size(); ++j) {
      lower.push_back({positions[j], normals[j]});
    }
    add_grid_band(mesh, upper, lower);
    upper = std::move(lower);
  }
  add_cap(mesh, upper, -0.5, stacks, -1);
  return mesh;
}

}  // namespace

Mesh realtime_mesh(Shape shape, const TessellationParameters& parameters) {
  const int p1 = std::clamp(parameters.parameter1, 1, max_tessellation);
  const int wedges = std::clamp(parameters.parameter2, 3, max_tessellation);
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
