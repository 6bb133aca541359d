// World-space normals in normals mode: (n + 1) / 2.

#include "trace/build_scene.h"

#include <gtest/gtest.h>

namespace scenefile::trace_test {
namespace {

glm::dvec3 normal_seen(SceneBuilder& b) {
  return 2.0 * b.seen(Profile::course, Mode::normals) - 1.0;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_NEAR(a.x, b.x, 1e-6);
  EXPECT_NEAR(a.y, b.y, 1e-6);
  EXPECT_NEAR(a.z, b.z, 1e-6);
}

SceneBuilder one(Shape shape, const Affine& place, const glm::dvec3& from, const glm::dvec3& at) {
  SceneBuilder b;
  b.add(shape, place, b.material({}));
  b.look(from, at);
  return b;
}

TEST(Normals, ConeSideLeansUpByItsSlope) {
  SceneBuilder b = one(Shape::cone, Affine(), {3, 0, 0}, {0, 0, 0});
  expect_near(normal_seen(b), glm::normalize(glm::dvec3(2, 1, 0)));
}

TEST(Normals, ConeHasABase) {
  SceneBuilder b = one(Shape::cone, Affine(), {0.1, -3, 0.1}, {0.1, 0, 0.1});
  expect_near(normal_seen(b), {0, -1, 0});
}

TEST(Normals, FollowTheInverseTransposeUnderUnevenScale) {
  // The ellipsoid x^2/4 + y^2 = 1/4: its normal at a point is parallel to (x/4, y).
  SceneBuilder b = one(Shape::sphere, scale({2, 1, 1}), {0.6, 3, 0}, {0.6, 0, 0});
  const double y = std::sqrt(0.25 - 0.6 * 0.6 / 4);
  expect_near(normal_seen(b), glm::normalize(glm::dvec3(0.6 / 4, y, 0)));
}

TEST(Normals, PointOutwardUnderMirroredScale) {
  SceneBuilder b = one(Shape::cone, scale({-1, 1, 1}), {3, 0, 0}, {0, 0, 0});
  expect_near(normal_seen(b), glm::normalize(glm::dvec3(2, 1, 0)));
  SceneBuilder upside_down = one(Shape::cone, scale({1, -1, 1}), {3, 0, 0}, {0, 0, 0});
  expect_near(normal_seen(upside_down), glm::normalize(glm::dvec3(2, -1, 0)));
}

TEST(Normals, RotateWithTheObject) {
  SceneBuilder b = one(Shape::cube, rotate(30, {0, 0, 1}), {3, 0, 0}, {0, 0, 0});
  expect_near(normal_seen(b), {std::sqrt(0.75), 0.5, 0});
}

TEST(Normals, AreNotFlippedTowardTheViewer) {
  SceneBuilder b = one(Shape::sphere, scale(glm::vec3(10)), {0, 0, 0}, {1, 0, 0});
  expect_near(normal_seen(b), {1, 0, 0});
}

TEST(Normals, OfMeshesMirroredPointOutward) {
  SceneBuilder b;
  RenderPrimitive p = b.primitive(Shape::mesh, scale({1, 1, -1}), b.material({}));
  Mesh m;
  m.positions = {{-5, 0, 5}, {5, 0, 5}, {0, 0, -5}};
  m.triangles = {{0, 1, 2}};
  p.mesh = b.mesh(m);
  b.scene.groups[0].primitives.push_back(p);
  b.look({0, 3, 0}, {0, 0, 0});
  expect_near(normal_seen(b), {0, 1, 0});
}

TEST(Normals, BackgroundIsBlack) {
  SceneBuilder b = one(Shape::cube, Affine(), {0, 3, 0}, {0, 6, 0});
  EXPECT_EQ(b.seen(Profile::course, Mode::normals), glm::dvec3(0));
  EXPECT_EQ(b.seen(Profile::fine, Mode::normals), glm::dvec3(0));
}

}  // namespace
}  // namespace scenefile::trace_test
