#include "builders.h"
#include "scenefile/scene/node_path.h"
#include "scenefile/scene/prepare.h"

#include <gtest/gtest.h>

#include <numeric>
#include <utility>

using namespace scenefile;
using namespace scenefile::test;

namespace {

Scene two_groups() {
  Scene scene = fine_scene();
  add_primitive(scene, 0, {translate(1, 0, 0)}, Shape::cube);
  add_primitive(scene, 0, {scale(1, 2, 1)}, Shape::cone);
  add_primitive(scene, add_template(scene, "t"));
  return scene;
}

// The same tree with its nodes in the opposite order.
Scene renumbered(const Scene& scene) {
  Scene result = scene;
  const auto flip = [&](NodeId id) { return static_cast<NodeId>(scene.nodes.size() - 1 - id); };
  for (NodeId id = 0; id < scene.nodes.size(); ++id) {
    Node node = scene.nodes[id];
    for (NodeId& child : node.children) {
      child = flip(child);
    }
    result.nodes[flip(id)] = std::move(node);
  }
  result.root = flip(scene.root);
  for (NodeId& head : result.templates) {
    head = flip(head);
  }
  return result;
}

}  // namespace

TEST(SceneEquality, IgnoresNumbering) {
  EXPECT_EQ(two_groups(), renumbered(two_groups()));
}

TEST(SceneEquality, IgnoresPlaces) {
  Scene placed = two_groups();
  placed.global.location = {1, 1};
  for (Node& node : placed.nodes) {
    node.location = {7, 7};
    for (Transform& t : node.transforms) {
      t.location = {8, 8};
    }
  }
  placed.field_places.push_back({{7, 7}, Field::color, {9, 9}});
  EXPECT_EQ(two_groups(), placed);
}

TEST(SceneEquality, IgnoresNodesOutsideTheScene) {
  Scene more = two_groups();
  more.nodes.emplace_back();
  EXPECT_EQ(two_groups(), more);
}

TEST(SceneEquality, SeesEveryKindOfChange) {
  const auto differs = [](auto change) {
    Scene changed = two_groups();
    change(changed);
    return !(two_groups() == changed) && !(changed == two_groups());
  };
  EXPECT_TRUE(differs([](Scene& s) { s.name = std::string("other"); }));
  EXPECT_TRUE(differs([](Scene& s) { s.global.ambient = 0.4f; }));
  EXPECT_TRUE(differs([](Scene& s) { s.global.transparent = 0.5f; }));
  EXPECT_TRUE(differs([](Scene& s) { s.camera = Camera{}; }));
  EXPECT_TRUE(differs([](Scene& s) { s.nodes[0].name = std::string("other"); }));
  EXPECT_TRUE(differs([](Scene& s) { s.nodes[0].lights[0].id = 0; }));
  EXPECT_TRUE(differs([](Scene& s) { s.nodes[0].primitives[0].material.texture.emplace(); }));
  EXPECT_TRUE(differs([](Scene& s) { s.nodes[1].transforms[0] = scale(1, 0, 0); }));
  EXPECT_TRUE(differs([](Scene& s) { std::swap(s.nodes[0].children[0], s.nodes[0].children[1]); }));
  EXPECT_TRUE(differs([](Scene& s) { s.nodes[0].children.pop_back(); }));
  EXPECT_TRUE(differs([](Scene& s) { s.templates.clear(); }));
  EXPECT_TRUE(differs([](Scene& s) { s.nodes.back().primitives[0].shape = Shape::cube; }));
  EXPECT_TRUE(differs([](Scene& s) { s.nodes.back().instance_of = std::string("t"); }));
}

TEST(SceneEquality, EndsOnBrokenScenes) {
  Scene loop;
  loop.nodes[0].children = {0, 99};
  EXPECT_EQ(loop, loop);
  EXPECT_FALSE(loop == Scene{});
}

TEST(NodePath, NamesAndPlaces) {
  Scene scene = fine_scene();
  const NodeId arm = add_group(scene, 0);
  const NodeId hand = add_group(scene, arm);
  const NodeId finger = add_group(scene, hand);
  scene.nodes[hand].name = "hand";
  EXPECT_EQ(node_path(scene, 0), "root");
  EXPECT_EQ(node_path(scene, arm), "root/#1");
  EXPECT_EQ(node_path(scene, finger), "root/#1/hand/#1");
  const NodeId chair = add_template(scene, "chair");
  EXPECT_EQ(node_path(scene, add_group(scene, chair)), "chair/#1");
  EXPECT_EQ(node_path(scene, 12345), "");
  scene.nodes[0].name.clear();
  EXPECT_EQ(node_path(scene, arm), "root/#1");
}
