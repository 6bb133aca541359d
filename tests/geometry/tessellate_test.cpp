#include "scenefile/geometry/tessellate.h"

#include "geometry/solids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace scenefile {
namespace {

using glm::dvec3;
using test::analytic_shapes;
using test::implicit;
using test::name_of;

using std::numbers::pi;
constexpr int segment_counts[] = {3, 4, 5, 6, 7, 8, 13, 16, 32, 100};

struct Measure {
  double area = 0;
  double volume = 0;
};

Measure measure(const Mesh& mesh) {
  Measure sum;
  for (const auto& t : mesh.triangles) {
    const dvec3 a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
    sum.area += 0.5 * glm::length(glm::cross(b - a, c - a));
    sum.volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return sum;
}

Measure exact(Shape shape) {
  switch (shape) {
    case Shape::cube:
      return {6, 1};
    case Shape::cone:
      return {pi / 4 + pi / 2 * std::sqrt(1.25), pi / 12};
    case Shape::cylinder:
      return {pi + pi / 2, pi / 4};
    default:
      return {pi, pi / 6};
  }
}

// The face of a triangle, by its center.
Face face_of(Shape shape, const dvec3& middle) {
  Face best = Face::side;
  double least = 1;
  for (const Face face : test::faces_of(shape)) {
    const dvec3 normal = surface_at(shape, face, middle).normal;
    const bool cap = shape == Shape::cube || face != Face::side;
    const double gap = cap ? std::abs(glm::dot(middle, normal) - 0.5) : 0.2;
    if (gap < least) {
      least = gap;
      best = face;
    }
  }
  const bool on_cap = shape == Shape::cube || least < 1e-6;
  return on_cap ? best : Face::side;
}

TEST(Tessellate, VerticesAgreeWithTheExactSurface) {
  for (const Shape shape : analytic_shapes) {
    for (const int segments : segment_counts) {
      const Mesh mesh = tessellate(shape, segments);
      ASSERT_EQ(mesh.triangle_normals.size(), mesh.triangles.size());
      ASSERT_EQ(mesh.triangle_uvs.size(), mesh.triangles.size());
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        dvec3 middle(0);
        for (int i = 0; i < 3; ++i) {
          middle += dvec3(mesh.positions[mesh.triangles[t][i]]) / 3.0;
        }
        const Face face = face_of(shape, middle);
        for (int i = 0; i < 3; ++i) {
          const dvec3 p(mesh.positions[mesh.triangles[t][i]]);
          ASSERT_NEAR(implicit(shape, p), 0, 1e-7) << name_of(shape);
          const bool tip = face == Face::side && std::hypot(p.x, p.z) < 1e-9;
          const dvec3 where = tip && shape == Shape::cone ? middle : p;
          const Surface s = surface_at(shape, face, where);
          const dvec3 normal(mesh.normals[mesh.triangle_normals[t][i]]);
          ASSERT_LT(glm::length(normal - s.normal), 1e-6) << name_of(shape) << segments;
          const glm::dvec2 uv(mesh.uvs[mesh.triangle_uvs[t][i]]);
          const double expected_u = tip ? surface_at(shape, face, middle).uv.x : s.uv.x;
          const double du = std::abs(uv.x - expected_u);
          ASSERT_LT(std::min(du, 1 - du), 1e-6) << name_of(shape) << segments;
          ASSERT_NEAR(uv.y, surface_at(shape, face, p).uv.y, 1e-6) << name_of(shape) << segments;
        }
      }
    }
  }
}

TEST(Tessellate, IsWatertightAndWoundOutward) {
  for (const Shape shape : analytic_shapes) {
    for (const int segments : segment_counts) {
      const Mesh mesh = tessellate(shape, segments);
      std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
      for (const auto& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
          ++edges[{t[i], t[(i + 1) % 3]}];
        }
      }
      for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1) << name_of(shape);
        ASSERT_EQ(edges.count({edge.second, edge.first}), 1u) << name_of(shape);
      }
      // Euler's formula for a closed surface of genus 0.
      ASSERT_EQ(mesh.positions.size() - edges.size() / 2 + mesh.triangles.size(), 2u);
      for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const dvec3 flat = surface_at(mesh, t, 0.3, 0.3, false).normal;
        const dvec3 smooth = surface_at(mesh, t, 0.3, 0.3, true).normal;
        ASSERT_GT(glm::dot(flat, smooth), 0.3) << name_of(shape) << segments;
      }
      ASSERT_GT(measure(mesh).volume, 0);
    }
  }
}

// No triangle crosses the seam: u changes by at most one segment, or the texture would run
// backward.
TEST(Tessellate, UvSeamIsCut) {
  for (const Shape shape : {Shape::cone, Shape::cylinder, Shape::sphere}) {
    const Mesh mesh = tessellate(shape, 16);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const Surface s = surface_at(mesh, t, 0.3, 0.3, true);
      EXPECT_GT(glm::dot(glm::cross(s.tangent_u, s.tangent_v), s.normal), 0) << name_of(shape);
    }
  }
}

TEST(Tessellate, AreaAndVolumeTendToTheExactOnes) {
  for (const Shape shape : analytic_shapes) {
    const Measure goal = exact(shape);
    double last_error = 1;
    for (const int segments : {16, 32, 64, 128}) {
      const Measure m = measure(tessellate(shape, segments));
      EXPECT_LE(m.volume, goal.volume * (1 + 1e-6)) << "inside the convex shape";
      EXPECT_LE(m.area, goal.area * (1 + 1e-6));
      const double error = std::abs(m.volume / goal.volume - 1);
      EXPECT_LE(error, std::max(last_error / 3.5, 1e-6)) << name_of(shape) << segments;
      last_error = error;
    }
    EXPECT_LT(std::abs(measure(tessellate(shape, 128)).area / goal.area - 1), 2e-3);
  }
}

// Compares ray-triangle tests (Moeller and Trumbore) with the exact shape.
TEST(Tessellate, AFineOneIsHitWhereTheShapeIs) {
  std::mt19937_64 random(9);
  for (const Shape shape : analytic_shapes) {
    const Mesh mesh = tessellate(shape, 128);
    for (int i = 0; i < 100; ++i) {
      const dvec3 origin = 2.0 * test::random_direction(random);
      const dvec3 direction = 0.4 * test::random_direction(random) - origin;
      double best = 10;
      for (const auto& t : mesh.triangles) {
        const dvec3 a(mesh.positions[t[0]]);
        const dvec3 e1 = dvec3(mesh.positions[t[1]]) - a;
        const dvec3 e2 = dvec3(mesh.positions[t[2]]) - a;
        const dvec3 p = glm::cross(direction, e2);
        const double det = glm::dot(e1, p);
        const dvec3 s = origin - a;
        const dvec3 q = glm::cross(s, e1);
        const double u = glm::dot(s, p) / det;
        const double v = glm::dot(direction, q) / det;
        if (u >= 0 && v >= 0 && u + v <= 1) {
          best = std::min(best, glm::dot(e2, q) / det);
        }
      }
      ShapeHit hit{10, Face::side};
      intersect(shape, {origin, direction}, 0, 10, hit);
      if (hit.t < 10 && best < 10) {
        const Surface s = surface_at(shape, hit.face, origin + hit.t * direction);
        const double slope = std::abs(glm::dot(glm::normalize(direction), s.normal));
        EXPECT_NEAR(hit.t, best, 3e-4 / std::max(slope, 0.05)) << name_of(shape);
      }
    }
  }
}

TEST(Tessellate, ClampsTheSegments) {
  EXPECT_EQ(tessellate(Shape::sphere, -5).triangles.size(),
            tessellate(Shape::sphere, 3).triangles.size());
  EXPECT_EQ(tessellate(Shape::cylinder, 1 << 30).triangles.size(), 4u * 1024);
  EXPECT_EQ(tessellate(Shape::cube, 99).triangles.size(), 12u);
  EXPECT_TRUE(tessellate(Shape::mesh, 8).triangles.empty());
}

}  // namespace
}  // namespace scenefile
