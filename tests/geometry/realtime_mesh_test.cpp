#include "scenefile/geometry/realtime_mesh.h"

#include "geometry/solids.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

namespace scenefile {
namespace {

using glm::dvec3;
using test::analytic_shapes;
using test::implicit;

using std::numbers::pi;

void holds(const char* law, const std::function<void(Shape, TessellationParameters)>& body) {
  EXPECT_TRUE(rc::check(law, [&] {
    const Shape shape = *rc::gen::elementOf(
        std::vector<Shape>(std::begin(analytic_shapes), std::end(analytic_shapes)));
    const int most = 30;
    const int p1 = *rc::gen::inRange(-3, most);
    const int p2 = *rc::gen::inRange(-3, most);
    body(shape, {p1, p2});
  }));
}

dvec3 corner(const Mesh& mesh, std::size_t triangle, int k) {
  return dvec3(mesh.positions[mesh.triangles[triangle][k]]);
}

dvec3 normal_at(const Mesh& mesh, std::size_t triangle, int k) {
  return dvec3(mesh.normals[mesh.triangle_normals[triangle][k]]);
}

dvec3 flat_normal(const Mesh& mesh, std::size_t t) {
  return glm::normalize(
      glm::cross(corner(mesh, t, 1) - corner(mesh, t, 0), corner(mesh, t, 2) - corner(mesh, t, 0)));
}

bool is_cap(Shape shape, const dvec3& flat) {
  return shape != Shape::sphere && shape != Shape::cube && std::abs(flat.y) > 0.999;
}

TEST(RealtimeMesh, VerticesLieOnTheExactSurface) {
  holds("each vertex is on the surface", [](Shape shape, TessellationParameters parameters) {
    const Mesh mesh = realtime_mesh(shape, parameters);
    for (const glm::vec3& p : mesh.positions) {
      RC_ASSERT(std::abs(implicit(shape, dvec3(p))) < 1e-6);
    }
  });
}

TEST(RealtimeMesh, IsClosedAndWoundOutward) {
  holds("each edge is met once in each direction, the solid is convex",
        [](Shape shape, TessellationParameters parameters) {
          const Mesh mesh = realtime_mesh(shape, parameters);
          std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
          for (const auto& t : mesh.triangles) {
            for (int k = 0; k < 3; ++k) {
              ++edges[{t[k], t[(k + 1) % 3]}];
            }
          }
          for (const auto& [edge, count] : edges) {
            RC_ASSERT(count == 1);
            RC_ASSERT(edges.count({edge.second, edge.first}) == 1u);
          }
          // Euler's formula for a surface of genus 0; all positions are used.
          RC_ASSERT(mesh.positions.size() + mesh.triangles.size() == edges.size() / 2 + 2);
          for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            RC_ASSERT(glm::dot(flat_normal(mesh, t), corner(mesh, t, 0)) > 0);
          }
        });
}

TEST(RealtimeMesh, NormalsAreThoseOfTheExactSurface) {
  holds("normals of corners", [](Shape shape, TessellationParameters parameters) {
    const Mesh mesh = realtime_mesh(shape, parameters);
    RC_ASSERT(mesh.triangle_normals.size() == mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const dvec3 flat = flat_normal(mesh, t);
      for (int k = 0; k < 3; ++k) {
        const dvec3 p = corner(mesh, t, k);
        dvec3 expected = flat;
        if (shape == Shape::sphere) {
          expected = 2.0 * p;
        } else if (shape == Shape::cylinder && !is_cap(shape, flat)) {
          expected = {2 * p.x, 0, 2 * p.z};
        } else if (shape == Shape::cone && !is_cap(shape, flat) && p.y < 0.4999) {
          const double r = std::hypot(p.x, p.z);
          expected = glm::normalize(dvec3(2 * p.x / r, 1, 2 * p.z / r));
        } else if (shape == Shape::cone && !is_cap(shape, flat)) {
          // The tip: midway between the two corners of its wedge.
          const dvec3 other = corner(mesh, t, (k + 1) % 3) + corner(mesh, t, (k + 2) % 3);
          const double r = std::hypot(other.x, other.z);
          expected = glm::normalize(dvec3(2 * other.x / r, 1, 2 * other.z / r));
        }
        RC_ASSERT(glm::length(normal_at(mesh, t, k) - expected) < 1e-5);
      }
    }
  });
}

TEST(RealtimeMesh, TheParametersCountRingsAndWedges) {
  holds("triangles", [](Shape shape, TessellationParameters parameters) {
    const Mesh mesh = realtime_mesh(shape, parameters);
    const int p1 = std::max(1, parameters.parameter1);
    const int p2 = std::max(3, parameters.parameter2);
    const int disk = p2 * (2 * p1 - 1);
    const int expected = shape == Shape::cube       ? 12 * p1 * p1
                         : shape == Shape::sphere   ? p2 * (2 * std::max(2, p1) - 2)
                         : shape == Shape::cylinder ? 2 * disk + 2 * p1 * p2
                                                    : 2 * disk;
    RC_ASSERT(mesh.triangles.size() == std::size_t(expected));
  });
}

TEST(RealtimeMesh, SpheresHaveRingsOfLatitudeFromTheNorthPole) {
  const Mesh mesh = realtime_mesh(Shape::sphere, {3, 5});
  const auto has = [&](const dvec3& p) {
    return std::any_of(mesh.positions.begin(), mesh.positions.end(),
                       [&](const glm::vec3& q) { return glm::length(dvec3(q) - p) < 1e-6; });
  };
  EXPECT_EQ(mesh.positions.size(), 2u + 2 * 5);
  for (const double phi : {pi / 3, 2 * pi / 3}) {
    for (int j = 0; j < 5; ++j) {
      const double theta = 2 * pi * j / 5;
      EXPECT_TRUE(has({0.5 * std::sin(phi) * std::cos(theta), 0.5 * std::cos(phi),
                       -0.5 * std::sin(phi) * std::sin(theta)}));
    }
  }
  EXPECT_TRUE(has({0, 0.5, 0}));
  EXPECT_TRUE(has({0, -0.5, 0}));
}

// Only the diagonal from the upper left to the lower right is an edge.
TEST(RealtimeMesh, QuadsAreSplitFromTheUpperLeftToTheLowerRight) {
  const Mesh cube = realtime_mesh(Shape::cube, {1, 1});
  for (std::size_t t = 0; t < cube.triangles.size(); ++t) {
    const dvec3 flat = flat_normal(cube, t);
    const dvec3 up = std::abs(flat.y) > 0.5 ? dvec3(0, 0, -flat.y) : dvec3(0, 1, 0);
    const dvec3 lower_left = -0.5 * (glm::cross(up, flat) + up) + 0.5 * flat;
    const dvec3 upper_right = 0.5 * (glm::cross(up, flat) + up) + 0.5 * flat;
    int ends = 0;
    for (int k = 0; k < 3; ++k) {
      const dvec3 p = corner(cube, t, k);
      ends += glm::length(p - lower_left) < 1e-6 || glm::length(p - upper_right) < 1e-6 ? 1 : 0;
    }
    EXPECT_EQ(ends, 1);
  }
  const Mesh sphere = realtime_mesh(Shape::sphere, {4, 6});
  for (std::size_t t = 0; t < sphere.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const dvec3 a = corner(sphere, t, k);
      const dvec3 b = corner(sphere, t, (k + 1) % 3);
      const double turn = glm::cross(a, b).y;  // positive: b is to the right of a
      const bool at_pole =
          std::abs(std::abs(a.y) - 0.5) < 1e-6 || std::abs(std::abs(b.y) - 0.5) < 1e-6;
      if (!at_pole && std::abs(turn) > 1e-6 && std::abs(a.y - b.y) > 1e-6) {
        EXPECT_EQ(turn > 0, b.y < a.y);
      }
    }
  }
}

TEST(RealtimeMesh, ExtremeParametersAreClamped) {
  const auto count = [](Shape shape, int p1, int p2) {
    return realtime_mesh(shape, {p1, p2}).triangles.size();
  };
  EXPECT_EQ(count(Shape::sphere, 1, 1), 6u);
  EXPECT_EQ(count(Shape::cone, 1, 1), 6u);
  EXPECT_EQ(count(Shape::cylinder, 1, 1), 12u);
  EXPECT_EQ(count(Shape::cube, -7, 0), 12u);
  EXPECT_EQ(count(Shape::cylinder, 1, 1 << 30), 4u * max_tessellation);
  EXPECT_EQ(count(Shape::sphere, 1 << 30, 3), 3u * (2 * max_tessellation - 2));
  EXPECT_EQ(count(Shape::mesh, 5, 5), 0u);
}

}  // namespace
}  // namespace scenefile
