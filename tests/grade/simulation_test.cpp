#include "scenefile/grade/simulation.h"

#include "grade/generated_scene.h"
#include "scenefile/grade/candidates.h"
#include "scenefile/grade/edited_scene.h"
#include "scenefile/grade/sampling_causes.h"
#include "trace/build_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

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

// The upper rows have many edges where the scene shows nothing.
TEST_F(WallOfSpheres, SamplesThatMissAreLookedForInAllRows) {
  constexpr int large = 256;
  const Texture rows = quantize(builder_.picture(large, large, view_.options), Rounding::truncate);
  Texture reference{large, 2 * large, {}};
  for (int y = 0; y < 2 * large; ++y) {
    for (int x = 0; x < large; ++x) {
      for (int c = 0; c < 3; ++c) {
        reference.rgb.push_back(y >= large          ? rows.texel(x, y - large)[c]
                                : x % 2 + y % 2 > 0 ? std::uint8_t{0}
                                                    : std::uint8_t{200});
      }
    }
  }
  SceneView lower = view_;
  lower.whole = glm::dvec2(large);
  lower.corner = {0, -large};
  Simulation all{rows, rows, &view_, go_on_};
  all.look_at_scene();
  Trial trial = all.right_trial(false);
  trial.samples = 2;
  trial.black_if_missed = true;
  std::vector<Point> points;
  for (int i = 0; i < large * large; ++i) {
    points.push_back({i % large, i / large});
  }
  const Colors colors = all.draw(trial, *all.shapes, points, points.size(), Turn(), nullptr);
  Texture test = reference;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      test.rgb[3 * (std::size_t{large} * large + i) + std::size_t(c)] =
          static_cast<std::uint8_t>(std::clamp(colors[i][c], 0.0, 255.0));
    }
  }
  Simulation sim{reference, test, &lower, go_on_};
  sim.look_at_scene();
  EXPECT_TRUE(claim_of_missed_samples(sim).has_value());
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

// Where all is as the mistakes make it, few rays are needed to see that, whatever the size.
TEST(EditedScenes, BesideMistakesAreLookedForWithFewRays) {
  const GeneratedScene scene(1);
  const Scene written = scene.written();
  const RenderScene ready = prepare(written, Limits()).scene;
  const SceneView view{
      &ready, &scene.builder.assets, default_options(Profile::course), &written, {}};
  Texture black{1024, 768, std::vector<std::uint8_t>(3 * 1024 * 768)};
  const std::function<bool(double)> go_on;
  Simulation sim{black, black, &view, go_on};
  sim.look_at_scene();
  sim.usable = true;
  sim.list.push_back({Cause::ambient,
                      "nothing is lit",
                      Stage::shading,
                      [](Trial& t) {
                        t.scene.lights.clear();
                        t.scene.global.ambient = 0;
                        t.options.features.reflect = false;
                      },
                      {},
                      {}});
  std::mt19937 random(1);
  add_points(black, black, {100, 5000, 300000, 400000}, 4, true, false, random, sim.points);
  sim.prepare_clean();
  const std::uint64_t before = sim.rays;
  EXPECT_FALSE(find_edit_beside(sim, {0}).has_value());
  EXPECT_GT(sim.rays, before);
  EXPECT_LT(sim.rays - before, 60'000u);
}

TEST(Lights, KeepTheirFunctionsWhenOthersAreLeftOut) {
  trace_test::SceneBuilder builder;
  RenderMaterial white;
  white.diffuse = glm::vec3(1);
  builder.add(Shape::sphere, trace_test::translate({0, 0, -3}), builder.material(white));
  for (const float attenuation : {0.5f, 2.0f}) {
    builder.light(LightType::point, {0, 0, 0}, glm::vec3(1)).attenuation = {attenuation, 0, 0};
  }
  builder.look({0, 0, 0}, {0, 0, -1});
  const auto shapes = flatten(builder.scene, builder.assets);
  ModelMistakes mistakes;
  mistakes.fading.emplace_back(builder.scene.lights[1].attenuation, Curve{{0, 10}, {0.25, 0.25}});
  const auto shares = [&](const RenderScene& drawn) {
    const Model model(drawn, *shapes, builder.assets, default_options(Profile::course), mistakes);
    return model.light_shares({{0, 0, 0}, {0, 0, -1}});
  };
  RenderScene second = builder.scene;
  second.lights.erase(second.lights.begin());
  const auto both = shares(builder.scene);
  const auto one = shares(second);
  ASSERT_EQ(both.size(), 2u);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_GT(one[0].x, 0);
  EXPECT_EQ(one[0], both[1]);
  EXPECT_NE(one[0], both[0]);
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
