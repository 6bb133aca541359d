#include "scenefile/scene/summary.h"

#include "builders.h"

#include <gtest/gtest.h>

using namespace scenefile;
using namespace scenefile::test;

TEST(Summary, CountsTheContentsOfTheFile) {
  Scene scene = fine_scene();
  const NodeId chair = add_template(scene, "chair");
  add_primitive(scene, chair, {translate(1, 0, 0), scale(1, 2, 1)}, Shape::cube);
  scene.nodes[chair].lights = {point_light()};
  add_instance(scene, 0, "chair");
  add_instance(scene, 0, "chair", {rotate({0, 1, 0}, 30)});
  Primitive mesh = primitive(Shape::mesh);
  mesh.mesh_file = "m.obj";
  mesh.material.texture = TextureUse{"t.png", 1, 1, {}};
  scene.nodes[0].primitives.insert(scene.nodes[0].primitives.end(), {mesh, mesh});
  SceneSummary expected;
  expected.nodes = 5;
  expected.depth = 2;
  expected.transforms = 3;
  expected.primitives = {1, 0, 0, 1, 2};
  expected.lights = {2, 0, 0, 0};
  expected.templates = 1;
  expected.instances = 2;
  expected.instance_nesting = 1;
  expected.virtual_primitives = 5;
  expected.virtual_lights = 3;
  expected.materials = 2;
  expected.textures = 1;
  expected.meshes = 1;
  EXPECT_EQ(summarize(scene), expected);
}

TEST(Summary, BombsAreCountedNotWalked) {
  const SceneSummary summary = summarize(bomb(40, 10, true));
  EXPECT_NEAR(summary.virtual_primitives / 1e40, 1, 1e-9);
  EXPECT_EQ(summary.instance_nesting, 41u);
  EXPECT_EQ(summary.instances, 401u);
}

TEST(Summary, LoopsCountNothing) {
  Scene scene;
  const NodeId a = add_template(scene, "a");
  const NodeId b = add_template(scene, "b");
  scene.nodes[a].primitives = {primitive()};
  add_instance(scene, a, "a");
  add_instance(scene, a, "b");
  add_instance(scene, b, "a");
  add_instance(scene, 0, "a");
  EXPECT_EQ(summarize(scene).virtual_primitives, 1);
  EXPECT_EQ(summarize(scene).instance_nesting, 2u);
}
