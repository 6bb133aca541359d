#include "scenefile/explain/object_names.h"

#include "scene/builders.h"

#include <gtest/gtest.h>

namespace scenefile {
namespace {

using namespace test;

// The object hit by the ray through the center of the picture.
std::string seen(const Scene& scene) {
  const Prepared ready = prepare(scene, {});
  RenderOptions options = default_options(Profile::course);
  options.width = options.height = 1;
  const Assets assets;
  const PixelRecord pixel = Explainer(ready.scene, assets, options).explain(0, 0);
  if (!pixel.samples[0].object.has_value()) {
    return "";
  }
  const ObjectNames names(scene, ready.sources);
  EXPECT_EQ(names.way(*pixel.samples[0].object).size(),
            pixel.samples[0].object->instances.size() + 1);
  return names.text(*pixel.samples[0].object);
}

Scene empty_scene() {
  Scene scene;
  scene.nodes[0].name = "root";
  Camera camera;
  camera.position = {0, 0, 5};
  camera.look = {0, 0, -1};
  scene.camera = camera;
  return scene;
}

TEST(ObjectNames, NameNodesFromTheRoot) {
  Scene scene = empty_scene();
  EXPECT_EQ(seen(scene), "");
  const NodeId board = add_group(scene, scene.root);
  scene.nodes[board].name = "board";
  add_primitive(scene, board, {translate(0, 9, 0)});
  add_primitive(scene, board);
  EXPECT_EQ(seen(scene), "root/board/#2");
}

TEST(ObjectNames, GoThroughEveryCopy) {
  Scene scene = empty_scene();
  const NodeId leg = add_template(scene, "leg");
  add_primitive(scene, leg);
  const NodeId chair = add_template(scene, "chair");
  add_instance(scene, chair, "leg", {translate(4, 0, 0)});
  add_instance(scene, chair, "leg");
  add_instance(scene, scene.root, "chair", {translate(0, 4, 0)});
  add_instance(scene, scene.root, "chair");
  EXPECT_EQ(seen(scene), "root/#2 > chair/#2 > leg/#1");
}

// Enough instances that the tracer does not flatten the template.
TEST(ObjectNames, GoThroughUnmergedTemplates) {
  Scene scene = empty_scene();
  const NodeId wall = add_template(scene, "wall");
  for (int i = 0; i < 3000; ++i) {
    add_primitive(scene, wall, {translate(float(i % 50), float(i / 50), 0), scale(0.9f, 0.9f, 1)});
  }
  for (int i = 0; i < 4; ++i) {
    add_instance(scene, scene.root, "wall", {translate(-7, -3, -float(i))});
  }
  EXPECT_EQ(seen(scene), "root/#1 > wall/#158");
}

TEST(ObjectNames, KnowTheLine) {
  Scene scene = empty_scene();
  const NodeId node = add_primitive(scene, scene.root);
  scene.nodes[node].primitives[0].location = {12, 7};
  const Prepared ready = prepare(scene, {});
  const ObjectNames names(scene, ready.sources);
  const std::uint32_t source = ready.scene.groups[ready.scene.root].primitives[0].source;
  EXPECT_EQ(names.at(source).location, (Location{12, 7}));
  EXPECT_EQ(names.at(no_index).path, "");
}

}  // namespace
}  // namespace scenefile
