#include "scenefile/trace/merge_groups.h"

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
  MergePlan plan(const MergeLimits& limits = {}) { return plan_merge(b.scene, limits); }
  std::vector<MergedPart> parts(const MergePlan& plan) {
    return merged_parts(b.scene, plan, b.scene.root);
  }
};

constexpr MergeLimits copy_nothing{0, 0};

TEST(MergeGroups, GroupsUsedOnceAreMerged) {
  Groups g;
  const std::uint32_t leaf = g.group(100);
  const std::uint32_t middle = g.group(1);
  g.use(leaf, {0, 1, 0});
  g.group(1);
  g.use(middle, {0, 0, 1});
  const MergePlan plan = g.plan(copy_nothing);
  EXPECT_EQ(plan.nesting, 0u);
  const std::vector<MergedPart> parts = g.parts(plan);
  ASSERT_EQ(parts.size(), 102u);
  EXPECT_EQ(parts[101].group_from_part.offset, glm::dvec3(99, 1, 1));
}

TEST(MergeGroups, SmallSharedGroupsAreCopied) {
  Groups g;
  const std::uint32_t leaf = g.group(20);
  g.group(0);
  g.use(leaf, {0, 0, 0});
  g.use(leaf, {0, 1, 0});
  EXPECT_EQ(g.plan().nesting, 0u);
  EXPECT_EQ(g.parts(g.plan()).size(), 40u);
  EXPECT_EQ(g.plan(copy_nothing).nesting, 1u);
  EXPECT_EQ(g.parts(g.plan(copy_nothing)).size(), 2u);
}

TEST(MergeGroups, LargeSharedGroupsStay) {
  Groups g;
  const std::uint32_t leaf = g.group(40000);
  g.group(1);
  g.use(leaf, {0, 0, 0});
  g.use(leaf, {0, 1, 0});
  const MergePlan plan = g.plan();
  EXPECT_EQ(plan.nesting, 1u);
  EXPECT_TRUE(plan.kept[leaf]);
  EXPECT_EQ(g.parts(plan).size(), 3u);
}

TEST(MergeGroups, IdenticalInstancesCountOnce) {
  Groups g;
  const std::uint32_t leaf = g.group(10);
  g.group(0);
  for (int i = 0; i < 5; ++i) {
    g.use(leaf, {1, 2, 3});
  }
  EXPECT_EQ(g.parts(g.plan(copy_nothing)).size(), 10u);
}

TEST(MergeGroups, PartsComeInTheOrderOfTheFile) {
  Groups g;
  const std::uint32_t leaf = g.group(1);
  g.group(1);
  g.use(leaf, {5, 0, 0});
  g.b.scene.groups.back().primitives.push_back(
      g.b.primitive(Shape::sphere, translate({9, 0, 0}), g.m));
  const std::vector<MergedPart> parts = g.parts(g.plan());
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].group_from_part.offset.x, 0);
  EXPECT_EQ(parts[1].group_from_part.offset.x, 5);
  EXPECT_EQ(parts[2].group_from_part.offset.x, 9);
}

std::size_t all_parts(const RenderScene& scene, const MergePlan& plan) {
  std::size_t count = 0;
  for (std::uint32_t g = 0; g < scene.groups.size(); ++g) {
    count += plan.kept[g] ? merged_parts(scene, plan, g).size() : 0;
  }
  return count;
}

TEST(MergeGroups, ABombStaysSmall) {
  Groups g;
  std::uint32_t last = g.group(10);
  for (int level = 0; level < 40; ++level) {
    const std::uint32_t next = g.group(0);
    for (int i = 0; i < 10; ++i) {
      g.use(last, {0.1f * float(i), 0, 0});
    }
    last = next;
  }
  const MergePlan plan = g.plan();
  EXPECT_LE(all_parts(g.b.scene, plan), 40u * 65536);
  EXPECT_LE(plan.nesting, 20u);
}

TEST(MergeGroups, TotalCopiesAreBounded) {
  Groups g;
  std::vector<std::uint32_t> leaves;
  for (int i = 0; i < 100; ++i) {
    leaves.push_back(g.group(10));
  }
  g.group(0);
  for (int i = 0; i < 1000; ++i) {
    g.use(leaves[i % 100], {0, float(i), 0});
  }
  EXPECT_EQ(g.parts(g.plan({100000, 100000})).size(), 10000u);
  EXPECT_EQ(g.parts(g.plan({100000, 5000})).size(), 1000u);
}

TEST(MergeGroups, LongChainsOfSingleThingsAreFollowedOnce) {
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
  const MergePlan plan = g.plan();
  EXPECT_EQ(g.parts(plan).size(), 5000u);
  EXPECT_EQ(plan.nesting, 1u);
  EXPECT_EQ(merged_parts(g.b.scene, plan, last)[0].group_from_part.offset.y, 1000);
}

TEST(MergeGroups, SceneWithoutGroups) {
  const RenderScene scene;
  EXPECT_EQ(plan_merge(scene).nesting, 0u);
}

}  // namespace
}  // namespace scenefile::trace_test
