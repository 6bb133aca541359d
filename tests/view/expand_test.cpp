#include "scenefile/view/expand.h"

#include "view/build_scene.h"

namespace scenefile {

namespace {

using namespace view_test;

TEST(Expand, MultipliesTransformsAndKeepsTheInstances) {
  SceneBuilder builder;
  const std::uint32_t material = builder.glowing({1, 1, 1});
  builder.add(Shape::sphere, place({1, 0, 0}), material);  // source 0
  builder.scene.groups.emplace_back();
  builder.add_instance(0, place({0, 2, 0}, 2));  // source 1
  builder.scene.groups.emplace_back();
  builder.add(Shape::cube, place({0, 0, 0}), material);  // source 2
  builder.add_instance(1, place({0, 0, 3}, 3));          // source 3
  const ExpandedScene expanded = expand(builder.scene, builder.assets, 100);
  ASSERT_EQ(expanded.objects.size(), 2u);
  EXPECT_TRUE(expanded.complete);
  EXPECT_EQ(expanded.names[0].source, 2u);
  EXPECT_EQ(expanded.names[0].placement, no_index);
  EXPECT_EQ(expanded.objects[1].world_from_object.point(glm::vec3(0)), glm::vec3(6, 6, 3));
  EXPECT_NEAR(expanded.objects[1].box_max.x, 9, 1e-5);
  const Placement inner = expanded.placements[expanded.names[1].placement];
  EXPECT_EQ(inner.source, 1u);
  EXPECT_EQ(expanded.placements[inner.parent].source, 3u);
  EXPECT_EQ(expanded.placements[inner.parent].parent, no_index);
}

TEST(Expand, TemplateBombsEndAtTheLimit) {
  SceneBuilder builder;
  builder.add(Shape::cube, place({0, 0, 0}), builder.glowing({1, 1, 1}));
  for (std::uint32_t level = 0; level < 60; ++level) {
    builder.scene.groups.emplace_back();
    builder.add_instance(level, place({1, 0, 0}));
    builder.add_instance(level, place({-1, 0, 0}));
  }
  const ExpandedScene expanded = expand(builder.scene, builder.assets, 1000);
  EXPECT_EQ(expanded.objects.size(), 1000u);
  EXPECT_FALSE(expanded.complete);
  EXPECT_FALSE(expanded.largest) << "all have one size";
}

TEST(Expand, TheSmallestAreLeftOut) {
  SceneBuilder builder;
  const std::uint32_t material = builder.glowing({1, 1, 1});
  builder.add(Shape::sphere, place({0, 0, 0}), material);
  for (std::uint32_t level = 0; level < 8; ++level) {
    builder.scene.groups.emplace_back();
    builder.add(Shape::sphere, place({0, 0, 0}), material);
    builder.add_instance(level, place({1, 0, 0}, 0.4f));
    builder.add_instance(level, place({-1, 0, 0}, 0.4f));
    builder.add_instance(level, place({0, 1, 0}, 0.4f));
  }
  const ExpandedScene expanded = expand(builder.scene, builder.assets, 1000);
  EXPECT_FALSE(expanded.complete);
  EXPECT_TRUE(expanded.largest);
  EXPECT_EQ(expanded.objects.size(), 364u) << "1 + 3 + 9 + ... + 243 of 9841";
  for (const WorldObject& object : expanded.objects) {
    EXPECT_GT(object.box_max.x - object.box_min.x, 0.01);
  }
}

TEST(Expand, AMeshThatIsNotLoadedIsNotDrawn) {
  SceneBuilder builder;
  builder.scene.mesh_files.push_back({});
  builder.assets.meshes.emplace_back();
  builder.add(Shape::mesh, place({0, 0, 0}), builder.glowing({1, 1, 1}));
  builder.scene.groups[0].primitives[0].mesh = 0;
  EXPECT_TRUE(expand(builder.scene, builder.assets, 10).objects.empty());
}

}  // namespace

}  // namespace scenefile
