// Nested templates.

#include "support/cpu_time.h"
#include "trace/build_scene.h"

#include <gtest/gtest.h>

namespace scenefile::trace_test {
namespace {

RenderOptions small_options(Profile profile) {
  RenderOptions options = default_options(profile);
  options.threads = 2;
  return options;
}

// Spheres with smaller spheres on six sides, `levels` deep, with one group per level.
SceneBuilder fractal(int levels) {
  SceneBuilder b;
  b.scene.groups.clear();
  RenderMaterial m;
  m.ambient = glm::vec3(0.125);
  m.reflective = glm::vec3(0.25);
  const std::uint32_t material = b.material(m);
  for (int level = 0; level < levels; ++level) {
    RenderGroup group;
    group.primitives.push_back(b.primitive(Shape::sphere, Affine(), material));
    for (int side = 0; level > 0 && side < 6; ++side) {
      glm::vec3 at(0);
      at[side / 2] = side % 2 == 0 ? 0.75f : -0.75f;
      group.instances.push_back(
          b.instance(static_cast<std::uint32_t>(level - 1),
                     translate(at) * rotate(20, {1, 1, 0}) * scale(glm::vec3(0.5))));
    }
    b.scene.groups.push_back(group);
  }
  b.scene.root = static_cast<std::uint32_t>(levels - 1);
  b.look({1.5, 1.2, 2}, {0, 0, 0}, 50);
  b.light(LightType::point, {3, 4, 5}, glm::vec3(0.75));
  return b;
}

// The same flattened to one group.
SceneBuilder flattened(const SceneBuilder& nested) {
  SceneBuilder flat = nested;
  RenderGroup all;
  struct Item {
    std::uint32_t group;
    Affine place;
  };
  std::vector<Item> open{{nested.scene.root, Affine()}};
  while (!open.empty()) {
    const Item item = open.back();
    open.pop_back();
    for (RenderPrimitive p : nested.scene.groups[item.group].primitives) {
      p.group_from_object = item.place * p.group_from_object;
      all.primitives.push_back(p);
    }
    for (const RenderInstance& i : nested.scene.groups[item.group].instances) {
      open.push_back({i.group, item.place * i.group_from_instance});
    }
  }
  flat.scene.groups = {all};
  flat.scene.root = 0;
  return flat;
}

TEST(Nesting, InstancesLookLikeCopies) {
  const SceneBuilder nested = fractal(6);
  const SceneBuilder flat = flattened(nested);
  ASSERT_EQ(count_virtual_primitives(nested.scene), count_virtual_primitives(flat.scene));
  const Image a = nested.picture(160, 120, small_options(Profile::course));
  const Image b = flat.picture(160, 120, small_options(Profile::course));
  int differ = 0;
  double lit = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    differ += std::abs(a.rgb[i] - b.rgb[i]) > 1e-4f ? 1 : 0;
    lit += a.rgb[i];
  }
  EXPECT_LT(differ, 3 * 160 * 120 / 100);  // silhouettes that differ by float rounding
  EXPECT_GT(lit, 1000);
}

TEST(Nesting, ABillionSpheresRender) {
  const SceneBuilder b = fractal(13);
  EXPECT_GT(count_virtual_primitives(b.scene), 1e9);
  const Image image = b.picture(64, 48, small_options(Profile::course));
  EXPECT_GT(image.pixel(32, 24)[0], 0);
}

// Forty levels of ten instances each, `step` apart.
SceneBuilder bomb(float step) {
  SceneBuilder b;
  const std::uint32_t material = b.glowing(glm::vec3(1));
  b.scene.groups.clear();
  b.scene.groups.emplace_back();
  b.scene.groups[0].primitives.push_back(b.primitive(Shape::sphere, Affine(), material));
  for (std::uint32_t level = 0; level < 40; ++level) {
    RenderGroup group;
    for (int i = 0; i < 10; ++i) {
      group.instances.push_back(b.instance(level, translate({step * float(i), 0, 0})));
    }
    b.scene.groups.push_back(group);
  }
  b.scene.root = 40;
  b.look({0, 0, 30}, {0, 0, 0});
  return b;
}

TEST(Nesting, BombsEndQuickly) {
  for (const float step : {0.0f, 1e-3f, 1.0f}) {
    const SceneBuilder b = bomb(step);
    RenderResult result;
    RenderOptions options = small_options(Profile::course);
    options.width = 32;
    options.height = 24;
    const double start = cpu_seconds();
    result = render(b.scene, b.assets, options);
    EXPECT_LT(cpu_seconds() - start, 20) << step;
    EXPECT_TRUE(result.status == RenderStatus::complete ||
                result.status == RenderStatus::limit_reached);
  }
}

// Groups with so many objects that no two levels can be flattened.
SceneBuilder deep(std::uint32_t levels) {
  constexpr int things = 256;
  SceneBuilder b;
  const std::uint32_t material = b.glowing(glm::vec3(1));
  b.scene.groups.clear();
  b.scene.groups.emplace_back();
  for (int i = 0; i < things; ++i) {
    b.scene.groups[0].primitives.push_back(
        b.primitive(Shape::sphere, translate({10 * float(i), 0, 0}), material));
  }
  for (std::uint32_t level = 0; level < levels; ++level) {
    b.scene.groups.emplace_back();
    for (int i = 0; i < things; ++i) {
      b.scene.groups.back().instances.push_back(
          b.instance(level, translate({10 * float(i), 0, 0})));
    }
  }
  b.scene.root = levels;
  b.look({0, 0, 2}, {0, 0, 0});
  return b;
}

TEST(Nesting, SixtyFourLevelsAreFollowedAndNoMore) {
  RenderOptions options = small_options(Profile::course);
  options.width = options.height = 4;
  options.threads = 4;
  const SceneBuilder most = deep(64);
  const RenderResult result = render(most.scene, most.assets, options);
  EXPECT_EQ(result.status, RenderStatus::complete);
  EXPECT_EQ(most.seen(options).x, 1);
  const SceneBuilder more = deep(65);
  EXPECT_EQ(render(more.scene, more.assets, options).status, RenderStatus::limit_reached);
}

}  // namespace
}  // namespace scenefile::trace_test
