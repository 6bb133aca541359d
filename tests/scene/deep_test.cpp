// Deeply nested scenes, which would overflow the stack of recursive functions.
#include "builders.h"
#include "scenefile/scene/check.h"
#include "scenefile/scene/codes.h"
#include "scenefile/scene/flatten.h"
#include "scenefile/scene/node_path.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/scene/summary.h"

#include <gtest/gtest.h>

using namespace scenefile;
using namespace scenefile::test;

namespace {

constexpr int depth = 100'000;

Scene deep_chain() {
  Scene scene = fine_scene();
  NodeId node = 0;
  for (int i = 0; i < depth; ++i) {
    node = add_group(scene, node, {translate(1, 0, 0)});
  }
  scene.nodes[node].primitives = {primitive(Shape::cube)};
  return scene;
}

// Template i instantiates template i - 1.
Scene template_chain() {
  Scene scene = fine_scene();
  add_primitive(scene, add_template(scene, "t0"));
  scene.nodes[scene.templates[0]].lights = {point_light()};
  for (int i = 1; i < depth; ++i) {
    const NodeId head = add_template(scene, numbered(i));
    add_instance(scene, head, numbered(i - 1));
  }
  add_instance(scene, 0, numbered(depth - 1));
  return scene;
}

}  // namespace

TEST(Deep, NodesAreCopiedComparedAndDestroyed) {
  const Scene scene = deep_chain();
  Scene copy = scene;
  EXPECT_EQ(scene, copy);
  copy.nodes.back().primitives[0].material.shininess = 1;
  EXPECT_FALSE(scene == copy);
  Spellings spellings;
  EXPECT_FALSE(flattened(scene, spellings));  // with billions of transforms
}

TEST(Deep, NodesAreCheckedAndPrepared) {
  const Scene scene = deep_chain();
  Diagnostics diagnostics;
  check(scene, Limits{}, diagnostics);
  EXPECT_TRUE(diagnostics.list().empty());
  const RenderScene got = prepare(scene, Limits{}).scene;
  ASSERT_EQ(got.groups.size(), 1u);
  EXPECT_EQ(got.groups[0].primitives.at(1).group_from_object.offset.x, static_cast<float>(depth));
  EXPECT_EQ(summarize(scene).depth, static_cast<std::size_t>(depth) + 1);
  EXPECT_EQ(node_path(scene, 1), "root/#1");
}

TEST(Deep, TemplatesAreRejectedSafely) {
  const Scene scene = template_chain();
  Diagnostics diagnostics;
  check(scene, Limits{}, diagnostics);
  EXPECT_EQ(diagnostics.count(Severity::error), 1u);
  const RenderScene got = prepare(scene, Limits{}).scene;
  EXPECT_EQ(instance_nesting(got), static_cast<std::uint32_t>(depth));
  EXPECT_EQ(count_virtual_primitives(got), 2);
  EXPECT_EQ(got.lights.size(), 2u);
}

TEST(Deep, ALongLoopIsFoundAndNamedShortly) {
  Scene scene = template_chain();
  add_instance(scene, scene.templates[0], numbered(depth - 1));
  Diagnostics diagnostics;
  check(scene, Limits{}, diagnostics);
  ASSERT_TRUE(diagnostics.has_errors());
  EXPECT_EQ(diagnostics.list()[0].code, &"tree.loop"_code);
  EXPECT_LT(diagnostics.list()[0].message.size(), 300u);
  EXPECT_GE(prepare(scene, Limits{}).scene.groups.size(), 1u);
}

TEST(Deep, FindingsWithoutAPlaceStayLinear) {
  Scene scene = deep_chain();
  for (Node& node : scene.nodes) {
    node.primitives = {primitive()};
    node.primitives[0].material.blend = 2;
  }
  Diagnostics diagnostics;
  check(scene, Limits{}, diagnostics);
  EXPECT_EQ(diagnostics.count(Severity::warning), static_cast<std::size_t>(depth) + 1);
}
