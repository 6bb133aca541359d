#include "scenefile/placement/bounds.h"

#include "trace/build_scene.h"

#include <gtest/gtest.h>

namespace scenefile::placement_test {
namespace {

using namespace trace_test;

TEST(SceneBounds, AreTightOutsideTemplates) {
  SceneBuilder b;
  b.add(Shape::sphere, translate({3, 0, 0}) * rotate(30, {0, 0, 1}), b.material({}));
  const Bounds box = scene_bounds(b.scene, b.assets);
  EXPECT_NEAR(box.min.x, 2.5, 1e-6);
  EXPECT_NEAR(box.max.x, 3.5, 1e-6);
  EXPECT_NEAR(box.max.y, 0.5, 1e-6);
}

TEST(SceneBounds, ContainInstancesAndMeshes) {
  SceneBuilder b;
  b.scene.groups.clear();
  RenderGroup inner;
  RenderPrimitive p = b.primitive(Shape::mesh, Affine(), b.material({}));
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  mesh.triangles = {{0, 1, 2}};
  p.mesh = b.mesh(mesh);
  inner.primitives.push_back(p);
  RenderGroup outer;
  outer.instances.push_back(b.instance(0, translate({10, 0, 0})));
  outer.instances.push_back(b.instance(0, translate({0, -5, 0})));
  b.scene.groups = {inner, outer};
  b.scene.root = 1;
  const Bounds box = scene_bounds(b.scene, b.assets);
  EXPECT_EQ(box.min, glm::dvec3(0, -5, 0));
  EXPECT_EQ(box.max, glm::dvec3(11, 2, 0));
}

TEST(SceneBounds, OfNothingAreEmpty) {
  EXPECT_TRUE(scene_bounds({}, {}).empty());
  SceneBuilder b;
  RenderPrimitive p = b.primitive(Shape::mesh, Affine(), b.material({}));
  p.mesh = b.mesh({});
  b.scene.groups[0].primitives.push_back(p);
  EXPECT_TRUE(scene_bounds(b.scene, b.assets).empty());
}

}  // namespace
}  // namespace scenefile::placement_test
