#include "scenefile/geometry/mesh.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scenefile {
namespace {

using glm::dvec2;
using glm::dvec3;

Mesh right_triangle() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {9, 9, 9}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

TEST(MeshSurface, FlatNormalFollowsTheOrderOfTheCorners) {
  Mesh mesh = right_triangle();
  EXPECT_EQ(surface_at(mesh, 0, 0.2, 0.3, false).normal, dvec3(0, 0, 1));
  mesh.triangles = {{0, 2, 1}};
  EXPECT_EQ(surface_at(mesh, 0, 0.2, 0.3, true).normal, dvec3(0, 0, -1));
}

TEST(DistinctTriangles, KeepTheLastOfEqualPlaces) {
  Mesh mesh = right_triangle();
  mesh.positions.insert(mesh.positions.end(), {{-0.0f, 0, 0}, {2, 0, 0}, {0, 3, 0}});
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {4, 5, 6}, {0, 1, 3}, {0, 2, 1}};
  EXPECT_EQ(distinct_triangles(mesh), (std::vector<std::uint32_t>{2, 3, 4}));
}

TEST(DistinctTriangles, DropThoseThatAreLines) {
  Mesh mesh = right_triangle();
  mesh.positions.push_back(mesh.positions[1]);
  mesh.triangles = {{0, 1, 1}, {0, 1, 2}, {4, 1, 2}, {3, 0, 3}};
  EXPECT_EQ(distinct_triangles(mesh), (std::vector<std::uint32_t>{1}));
  mesh.triangles = {{0, 0, 0}};
  EXPECT_TRUE(distinct_triangles(mesh).empty());
  EXPECT_TRUE(distinct_triangles({}).empty());
}

TEST(DistinctTriangles, AllOfAnOrdinaryMesh) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < 100; ++i) {
    mesh.positions.emplace_back(i % 10, i / 10, 0);
    if (i % 10 != 9 && i < 90) {
      mesh.triangles.push_back({i, i + 1, i + 10});
      mesh.triangles.push_back({i + 1, i + 11, i + 10});
    }
  }
  EXPECT_EQ(distinct_triangles(mesh).size(), mesh.triangles.size());
}

TEST(MeshSurface, SmoothNormalIsInterpolatedByDirection) {
  Mesh mesh = right_triangle();
  mesh.normals = {{0, 0, 5}, {7, 0, 0}, {0, 2, 0}};
  mesh.triangle_normals = {{0, 1, 2}};
  EXPECT_EQ(surface_at(mesh, 0, 0, 0, true).normal, dvec3(0, 0, 1));
  EXPECT_EQ(surface_at(mesh, 0, 1, 0, true).normal, dvec3(1, 0, 0));
  EXPECT_EQ(surface_at(mesh, 0, 0, 1, true).normal, dvec3(0, 1, 0));
  const dvec3 middle = surface_at(mesh, 0, 0.5, 0.5, true).normal;
  EXPECT_LT(glm::length(middle - dvec3(1, 1, 0) / std::sqrt(2.0)), 1e-15);
  EXPECT_EQ(surface_at(mesh, 0, 0.5, 0.5, false).normal, dvec3(0, 0, 1));
}

TEST(MeshSurface, SmoothFallsBackToFlat) {
  Mesh mesh = right_triangle();
  mesh.normals = {{0, 1, 0}, {0, -1, 0}};
  mesh.triangle_normals = {{mesh_no_index, mesh_no_index, mesh_no_index}};
  EXPECT_EQ(surface_at(mesh, 0, 0.2, 0.3, true).normal, dvec3(0, 0, 1));
  mesh.triangle_normals = {{0, 1, 0}};  // opposite normals cancel in the middle
  EXPECT_EQ(surface_at(mesh, 0, 0.5, 0, true).normal, dvec3(0, 0, 1));
}

TEST(MeshSurface, NormalsOfTinyHugeAndFlatTriangles) {
  for (const float size : {1e-45f, 1e-38f, 1e-20f, 1e20f, 3e38f}) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
    mesh.triangles = {{0, 1, 2}};
    EXPECT_EQ(surface_at(mesh, 0, 0.2, 0.3, false).normal, dvec3(0, 0, 1)) << size;
  }
  Mesh line;
  line.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  line.triangles = {{0, 1, 2}};
  EXPECT_NEAR(glm::length(surface_at(line, 0, 0.2, 0.3, false).normal), 1, 1e-15);
}

TEST(MeshSurface, UvAndTangents) {
  Mesh mesh = right_triangle();
  mesh.uvs = {{0.5f, 0.25f}, {1.5f, 0.25f}, {0.5f, -1.75f}};
  mesh.triangle_uvs = {{0, 1, 2}};
  const Surface s = surface_at(mesh, 0, 0.25, 0.5, false);
  EXPECT_EQ(s.uv, dvec2(0.75, -0.75));
  EXPECT_EQ(s.tangent_u, dvec3(2, 0, 0));     // u increases by 1 over 2 units of x
  EXPECT_EQ(s.tangent_v, dvec3(0, -1.5, 0));  // v decreases by 2 over 3 units of y
}

TEST(MeshSurface, NoUvNoTangents) {
  Mesh mesh = right_triangle();
  Surface s = surface_at(mesh, 0, 0.25, 0.5, false);
  EXPECT_EQ(s.uv, dvec2(0));
  EXPECT_EQ(s.tangent_u, dvec3(0));
  mesh.uvs = {{0.5f, 0.5f}};
  mesh.triangle_uvs = {{0, 0, 0}};
  s = surface_at(mesh, 0, 0.25, 0.5, false);
  EXPECT_EQ(s.uv, dvec2(0.5));
  EXPECT_EQ(s.tangent_u, dvec3(0));
  EXPECT_EQ(s.tangent_v, dvec3(0));
  mesh.triangle_uvs = {{mesh_no_index, mesh_no_index, mesh_no_index}};
  EXPECT_EQ(surface_at(mesh, 0, 0.25, 0.5, false).uv, dvec2(0));
}

TEST(MeshBounds, ContainOnlyTheTriangles) {
  const Bounds box = bounds(right_triangle());
  EXPECT_EQ(box.min, dvec3(0));
  EXPECT_EQ(box.max, dvec3(2, 3, 0));
  EXPECT_TRUE(bounds(Mesh{}).empty());
}

}  // namespace
}  // namespace scenefile
