#include "scenefile/grade/simulation.h"

#include "scenefile/grade/candidates.h"
#include "trace/build_scene.h"

#include <gtest/gtest.h>

namespace scenefile::grade_test {
namespace {

constexpr int size = 64;
constexpr std::uint16_t heaped = 0;
constexpr std::uint16_t darker = 1;
constexpr std::uint16_t no_lights = 2;

// A wall of many spheres, and mistakes of different kinds in it.
class WallOfSpheres : public ::testing::Test {
 protected:
  WallOfSpheres() {
    constexpr int across = 60;
    RenderMaterial gray;
    gray.ambient = glm::vec3(0.2f);
    gray.diffuse = glm::vec3(0.7f);
    const std::uint32_t material = builder_.material(gray);
    for (int i = 0; i < across * across; ++i) {
      builder_.add(Shape::sphere,
                   trace_test::translate({i % across - across / 2, i / across - across / 2, 0}),
                   material);
    }
    builder_.light(LightType::directional, {-1, -1, -2}, glm::vec3(0.8f));
    builder_.look({0, 0, 40}, {0, 0, 0});
    view_ = {&builder_.scene, &builder_.assets, default_options(Profile::course), nullptr, {}};
    reference_ = quantize(builder_.picture(size, size, view_.options), Rounding::truncate);
    builder_.scene.global.diffuse = 0.5f;
    test_ = quantize(builder_.picture(size, size, view_.options), Rounding::truncate);
    builder_.scene.global.diffuse = 1;
  }

  // Screens mistakes in a picture that is darker.
  void screen_mistakes(LookFor look_for, Simulation& sim) {
    const auto add = [&](Cause cause, Stage stage, std::function<void(Trial&)> draw) {
      sim.list.push_back({cause, {}, stage, std::move(draw), {}, {}});
    };
    add(Cause::transforms, Stage::shapes, [](Trial& t) {
      for (RenderPrimitive& p : t.scene.groups[t.scene.root].primitives) {
        p.group_from_object = trace_test::scale(glm::vec3(40));
      }
    });
    add(Cause::diffuse, Stage::shading, [](Trial& t) { t.scene.global.diffuse = 0.5f; });
    add(Cause::lights, Stage::shading, [](Trial& t) { t.scene.lights.clear(); });
    sim.look_at_scene();
    std::mt19937 random(1);
    const Pixels pixels = sorted_pixels(reference_, test_);
    add_points(reference_, test_, pixels.different, 120, true, false, random, sim.points);
    const std::size_t different = sim.points.size();
    add_points(reference_, test_, pixels.same, 40, false, false, random, sim.points);
    sim.interleave(different);
    sim.prepare_clean();
    sim.fill_cache(screen, look_for);
  }

  trace_test::SceneBuilder builder_;
  SceneView view_;
  Texture reference_;
  Texture test_;
  const std::function<bool(double)> go_on_;
};

TEST_F(WallOfSpheres, MistakesOfFarMoreWorkAreTriedAlone) {
  Simulation sim{reference_, test_, &view_, go_on_};
  screen_mistakes(LookFor::several_at_once, sim);
  EXPECT_TRUE(sim.any_heavy({heaped}));
  EXPECT_TRUE(sim.any_heavy({heaped, darker}));
  EXPECT_FALSE(sim.any_heavy({darker, no_lights}));
  EXPECT_FALSE(fits(sim, {heaped}, darker));
  EXPECT_TRUE(fits(sim, {darker}, no_lights));
  EXPECT_FALSE(sim.cache[heaped].empty());
}

TEST_F(WallOfSpheres, SingleMistakesAreDroppedAtAGlance) {
  Simulation sim{reference_, test_, &view_, go_on_};
  screen_mistakes(LookFor::single_mistakes, sim);
  EXPECT_FALSE(sim.cache[darker].empty());
  EXPECT_TRUE(sim.cache[heaped].empty());
}

TEST_F(WallOfSpheres, FewPointsAreAllThatThereAre) {
  Simulation sim{reference_, test_, &view_, go_on_};
  screen_mistakes(LookFor::several_at_once, sim);
  constexpr std::size_t count = 20;
  sim.points.resize(count);
  sim.prepare_clean();
  EXPECT_EQ(sim.predicted({darker}, few_points).size(), count);
  EXPECT_EQ(sim.base(few_points).differs, sim.base(count).differs);
  EXPECT_EQ(sim.score_of({darker}, few_points).left, sim.score_of({darker}, count).left);
}

TEST_F(WallOfSpheres, ShapesWithMistakesAreBuiltOnce) {
  Simulation sim{reference_, test_, &view_, go_on_};
  screen_mistakes(LookFor::several_at_once, sim);
  const auto shapes_with = [&](const Combination& mistakes) {
    return sim.shapes_of(mistakes, sim.trial_of(mistakes));
  };
  EXPECT_EQ(shapes_with({heaped}), shapes_with({heaped, darker}));
  EXPECT_EQ(shapes_with({darker}), sim.shapes);
  EXPECT_NE(shapes_with({heaped}), sim.shapes);
}

TEST(EditedScenes, AreNotLookedForWhereColorsAreLost) {
  Hypothesis edit;
  edit.cause = Cause::scene_edited;
  const auto stored = [](const std::function<glm::dvec3(const glm::dvec3&)>& color) {
    Hypothesis h;
    h.color = color;
    return h;
  };
  EXPECT_TRUE(hides(stored([](const glm::dvec3& c) { return glm::dvec3(0, c.g, 0); }), edit));
  EXPECT_TRUE(hides(stored([](const glm::dvec3& c) { return glm::dvec3((c.r + c.g) / 2); }), edit));
  EXPECT_FALSE(hides(stored([](const glm::dvec3& c) { return glm::dvec3(c.b, c.g, c.r); }), edit));
}

}  // namespace
}  // namespace scenefile::grade_test
