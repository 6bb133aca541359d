#include "scenefile/trace/flatten_instances.h"

#include "trace/build_scene.h"

#include <gtest/gtest.h>

namespace scenefile::trace_test {
namespace {

struct Groups {
  SceneBuilder b;
  std::uint32_t m = b.material({});

  Groups() { b.scene.groups.clear(); }

  std::uint32_t group(int primitives) {
    RenderGroup g;
    for (int i = 0; i < primitives; ++i) {
      g.primitives.push_back(b.primitive(Shape::sphere, translate({float(i), 0, 0}), m));
    }
    b.scene.groups.push_back(g);
    b.scene.root = static_cast<std::uint32_t>(b.scene.groups.size() - 1);
    return b.scene.root;
  }
  void use(std::uint32_t child, const glm::vec3& at) {
    b.scene.groups.back().instances.push_back(b.instance(child, translate(at)));
  }
  FlattenPlan plan(const FlattenLimits& limits = {}) { return plan_flattening(b.scene, limits); }
  std::vector<FlatObject> objects(const FlattenPlan& plan) {
    return flat_objects(b.scene, plan, b.scene.root);
  }
};

constexpr FlattenLimits copy_nothing{0, 0};

TEST(FlattenInstances, GroupsUsedOnceAreFlattened) {
  Groups g;
  const std::uint32_t leaf = g.group(100);
  const std::uint32_t middle = g.group(1);
  g.use(leaf, {0, 1, 0});
  g.group(1);
  g.use(middle, {0, 0, 1});
  const FlattenPlan plan = g.plan(copy_nothing);
  EXPECT_EQ(plan.nesting, 0u);
  const std::vector<FlatObject> objects = g.objects(plan);
  ASSERT_EQ(objects.size(), 102u);
  EXPECT_EQ(objects[101].group_from_object.offset, glm::dvec3(99, 1, 1));
}

TEST(FlattenInstances, SmallSharedGroupsAreCopied) {
  Groups g;
  const std::uint32_t leaf = g.group(20);
  g.group(0);
  g.use(leaf, {0, 0, 0});
  g.use(leaf, {0, 1, 0});
  EXPECT_EQ(g.plan().nesting, 0u);
  EXPECT_EQ(g.objects(g.plan()).size(), 40u);
  EXPECT_EQ(g.plan(copy_nothing).nesting, 1u);
  EXPECT_EQ(g.objects(g.plan(copy_nothing)).size(), 2u);
}

TEST(FlattenInstances, LargeSharedGroupsStay) {
  Groups g;
  const std::uint32_t leaf = g.group(40000);
  g.group(1);
  g.use(leaf, {0, 0, 0});
  g.use(leaf, {0, 1, 0});
  const FlattenPlan plan = g.plan();
  EXPECT_EQ(plan.nesting, 1u);
  EXPECT_TRUE(plan.kept[leaf]);
  EXPECT_EQ(g.objects(plan).size(), 3u);
}

TEST(FlattenInstances, IdenticalInstancesCountOnce) {
  Groups g;
  const std::uint32_t leaf = g.group(10);
  g.group(0);
  for (int i = 0; i < 5; ++i) {
    g.use(leaf, {1, 2, 3});
  }
  EXPECT_EQ(g.objects(g.plan(copy_nothing)).size(), 10u);
}

TEST(FlattenInstances, ObjectsComeInTheOrderOfTheFile) {
  Groups g;
  const std::uint32_t leaf = g.group(1);
  g.group(1);
  g.use(leaf, {5, 0, 0});
  g.b.scene.groups.back().primitives.push_back(
      g.b.primitive(Shape::sphere, translate({9, 0, 0}), g.m));
  const std::vector<FlatObject> objects = g.objects(g.plan());
  ASSERT_EQ(objects.size(), 3u);
  EXPECT_EQ(objects[0].group_from_object.offset.x, 0);
  EXPECT_EQ(objects[1].group_from_object.offset.x, 5);
  EXPECT_EQ(objects[2].group_from_object.offset.x, 9);
}

std::size_t all_objects(const RenderScene& scene, const FlattenPlan& plan) {
  std::size_t count = 0;
  for (std::uint32_t g = 0; g < scene.groups.size(); ++g) {
    count += plan.kept[g] ? flat_objects(scene, plan, g).size() : 0;
  }
  return count;
}

TEST(FlattenInstances, ABombStaysSmall) {
  Groups g;
  std::uint32_t last = g.group(10);
  for (int level = 0; level < 40; ++level) {
    const std::uint32_t next = g.group(0);
    for (int i = 0; i < 10; ++i) {
      g.use(last, {0.1f * float(i), 0, 0});
    }
    last = next;
  }
  const FlattenPlan plan = g.plan();
  EXPECT_LE(all_objects(g.b.scene, plan), 40u * 65536);
  EXPECT_LE(plan.nesting, 20u);
}

TEST(FlattenInstances, TotalCopiesAreBounded) {
  Groups g;
  std::vector<std::uint32_t> leaves;
  for (int i = 0; i < 100; ++i) {
    leaves.push_back(g.group(10));
  }
  g.group(0);
  for (int i = 0; i < 1000; ++i) {
    g.use(leaves[i % 100], {0, float(i), 0});
  }
  EXPECT_EQ(g.objects(g.plan({100000, 100000})).size(), 10000u);
  EXPECT_EQ(g.objects(g.plan({100000, 5000})).size(), 1000u);
}

TEST(FlattenInstances, LongChainsOfSingleThingsAreFollowedOnce) {
  Groups g;
  std::uint32_t last = g.group(1);
  for (int level = 0; level < 1000; ++level) {
    const std::uint32_t next = g.group(0);
    g.use(last, {0, 1, 0});
    last = next;
  }
  g.group(0);
  for (int i = 0; i < 5000; ++i) {
    g.use(last, {float(i), 0, 0});
  }
  const FlattenPlan plan = g.plan();
  EXPECT_EQ(g.objects(plan).size(), 5000u);
  EXPECT_EQ(plan.nesting, 1u);
  EXPECT_EQ(flat_objects(g.b.scene, plan, last)[0].group_from_object.offset.y, 1000);
}

TEST(FlattenInstances, SceneWithoutGroups) {
  const RenderScene scene;
  EXPECT_EQ(plan_flattening(scene).nesting, 0u);
}

}  // namespace
}  // namespace scenefile::trace_test
