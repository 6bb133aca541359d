#include "scenefile/trace/explain.h"

#include "trace/add_up.h"
#include "trace/random_scene.h"

#include <gtest/gtest.h>

namespace scenefile::trace_test {
namespace {

constexpr int width = 16;
constexpr int height = 12;

// Explains every pixel, with a different sample for each.
void expect_sums(const SceneBuilder& b, RenderOptions options) {
  options.width = width;
  options.height = height;
  const Image image = render(b.scene, b.assets, options).image;
  const Explainer explainer(b.scene, b.assets, options);
  ASSERT_EQ(explainer.status(), RenderStatus::complete);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const PixelRecord pixel = explainer.explain(x, y, static_cast<std::uint32_t>(x + y) % 7);
      ASSERT_EQ(what_does_not_add_up(b.scene, pixel), "") << x << ' ' << y;
      ASSERT_EQ(what_differs(pixel, image), "") << x << ' ' << y;
    }
  }
}

class ExplainedPixel : public testing::TestWithParam<std::uint32_t> {
 protected:
  RandomScene random{GetParam()};
};

TEST_P(ExplainedPixel, AddsUpInTheCourseProfile) {
  RenderOptions options = default_options(Profile::course);
  expect_sums(random.b, options);
  options.features.super_sample = true;
  expect_sums(random.b, options);
  options.features.texture_filter = false;
  options.mode = Mode::intersect;
  expect_sums(random.b, options);
}

TEST_P(ExplainedPixel, AddsUpInTheFineProfile) {
  RenderOptions options = default_options(Profile::fine);
  expect_sums(random.b, options);
  options.fresnel = true;
  expect_sums(random.b, options);
  options.samples = 1;
  options.seed = GetParam();
  expect_sums(random.b, options);
}

TEST_P(ExplainedPixel, AddsUpBehindALens) {
  random.scene().camera.aperture = 0.1;
  random.scene().camera.focal_length = 5;
  expect_sums(random.b, default_options(Profile::course));
  expect_sums(random.b, default_options(Profile::fine));
}

TEST_P(ExplainedPixel, AddsUpWhereColorsAreNormals) {
  for (const Profile profile : {Profile::course, Profile::fine}) {
    RenderOptions options = default_options(profile);
    options.mode = Mode::normals;
    options.features.super_sample = true;
    expect_sums(random.b, options);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExplainedPixel, testing::Range(1u, 9u));

TEST(ExplainedPicture, HasNoDenormalNumbers) {
  RenderMaterial faint;
  faint.ambient = {1e-30f, 0.5f, 1e-25f};
  SceneBuilder b;
  b.scene.global.ambient = 1e-12f;
  b.add(Shape::sphere, translate({0, 0, -2}), b.material(faint));
  for (const Profile profile : {Profile::course, Profile::fine}) {
    expect_sums(b, default_options(profile));
  }
}

PixelRecord middle(const SceneBuilder& b, Profile profile = Profile::course) {
  RenderOptions options = default_options(profile);
  options.width = options.height = 1;
  options.samples = 1;
  return Explainer(b.scene, b.assets, options).explain(0, 0);
}

SceneBuilder lit_ball(const RenderMaterial& material) {
  SceneBuilder b;
  b.add(Shape::sphere, translate({0, 0, -5}) * scale(glm::vec3(2)), b.material(material));
  b.light(LightType::point, {0, 0, 0}, glm::vec3(1));
  return b;
}

TEST(Explain, DescribesTheRayAndTheSurface) {
  const SceneBuilder b = lit_ball({});
  const PixelRecord pixel = middle(b);
  ASSERT_EQ(pixel.samples.size(), 1u);
  ASSERT_EQ(pixel.rays.size(), 1u);
  ASSERT_TRUE(pixel.rays[0].surface.has_value());
  const SurfaceRecord& s = *pixel.rays[0].surface;
  EXPECT_EQ(s.t, 4);
  EXPECT_EQ(s.position, glm::dvec3(0, 0, -4));
  EXPECT_EQ(s.object_position, glm::dvec3(0, 0, 0.5));
  EXPECT_EQ(s.object_ray.origin, glm::dvec3(0, 0, 2.5));
  EXPECT_EQ(s.object_ray.direction, glm::dvec3(0, 0, -0.5));
  EXPECT_EQ(s.normal, glm::dvec3(0, 0, 1));
  EXPECT_EQ(s.object_normal, glm::dvec3(0, 0, 1));
  ASSERT_EQ(pixel.rays[0].lights.size(), 1u);
  ASSERT_EQ(pixel.rays[0].lights[0].samples.size(), 1u);
  const LightSample& light = pixel.rays[0].lights[0].samples[0];
  EXPECT_EQ(light.distance, 4);
  EXPECT_EQ(light.n_dot_l, 1);
  EXPECT_TRUE(light.shadow_ray);
  EXPECT_EQ(light.contribution, Color(1));
  EXPECT_EQ(pixel.value[0], 255);
}

TEST(Explain, AMissIsOneBlackRay) {
  const PixelRecord pixel = middle(SceneBuilder());
  ASSERT_EQ(pixel.rays.size(), 1u);
  EXPECT_FALSE(pixel.rays[0].surface.has_value());
  EXPECT_FALSE(pixel.samples[0].object.has_value());
  EXPECT_EQ(pixel.color, Color(0));
}

TEST(Explain, NamesTheOccluder) {
  SceneBuilder b = lit_ball({});
  b.scene.lights[0].position = {0, 3, -4};
  b.add(Shape::cube, translate({0, 2, -4}), b.material({}));
  const PixelRecord pixel = middle(b);
  const LightSample& light = pixel.rays[0].lights[0].samples[0];
  ASSERT_EQ(light.visibility, Color(1)) << "grazing light needs no shadow ray";
  b.scene.lights[0].position = {0, 3, -3};
  b.add(Shape::cube, translate({0, 2, -3.2f}), b.material({}));
  const PixelRecord dark = middle(b);
  const LightSample& blocked = dark.rays[0].lights[0].samples[0];
  EXPECT_EQ(blocked.visibility, Color(0));
  ASSERT_EQ(blocked.blockers.size(), 1u);
  EXPECT_EQ(blocked.blockers[0].object.source, 2u);
  EXPECT_FALSE(blocked.blockers[0].itself);
  EXPECT_LT(blocked.blockers[0].t, blocked.distance);
}

TEST(Explain, ListsAllGlassInAShadow) {
  RenderMaterial glass;
  glass.transparent = {0.5f, 1, 1};
  SceneBuilder b = lit_ball({});
  b.scene.lights[0].position = {0, 10, 4};
  const std::uint32_t m = b.material(glass);
  b.add(Shape::sphere, translate({0, 4, -0.8f}), m);
  b.add(Shape::sphere, translate({0, 6, 0.8f}), m);
  const PixelRecord pixel = middle(b, Profile::fine);
  const LightSample& light = pixel.rays[0].lights[0].samples[0];
  ASSERT_EQ(light.blockers.size(), 2u);
  EXPECT_NEAR(light.visibility.x, 0.25, 1e-9);
  EXPECT_EQ(light.visibility.y, 1);
  EXPECT_NEAR(light.blockers[1].passes.x, 0.5, 1e-9);
}

TEST(Explain, NamesTheInstancesOnTheWay) {
  SceneBuilder b;
  b.scene.groups.clear();
  const std::uint32_t m = b.glowing(glm::vec3(1));
  RenderGroup inner;
  inner.primitives.push_back(b.primitive(Shape::sphere, translate({0, 0, -5}), m));
  b.scene.groups.push_back(inner);
  RenderGroup outer;
  outer.instances.push_back(b.instance(0, translate({9, 0, 0})));
  outer.instances.push_back(b.instance(0, translate({0, 0, 0})));
  b.scene.groups.push_back(outer);
  RenderGroup root;
  root.instances.push_back(b.instance(1, translate({0, 0, 0})));
  b.scene.groups.push_back(root);
  b.scene.root = 2;
  const PixelRecord pixel = middle(b);
  ASSERT_TRUE(pixel.samples[0].object.has_value());
  EXPECT_EQ(pixel.samples[0].object->source, 0u);
  EXPECT_EQ(pixel.samples[0].object->instances, (std::vector<std::uint32_t>{3, 2}));
}

TEST(Explain, SaysWhyABounceIsNotFollowed) {
  RenderMaterial mirror;
  mirror.reflective = glm::vec3(0.001f, 0, 0);
  const SceneBuilder b = lit_ball(mirror);
  RenderOptions options = default_options(Profile::fine);
  const auto outcome = [&] {
    return Explainer(b.scene, b.assets, options).explain(512, 384).rays[0].mirror.outcome;
  };
  EXPECT_EQ(outcome(), BranchOutcome::followed);
  options.max_depth = 0;
  EXPECT_EQ(outcome(), BranchOutcome::too_deep);
  options.features.reflect = false;
  EXPECT_EQ(outcome(), BranchOutcome::absent);
  mirror.reflective = glm::vec3(0.0009f, 0, 0);
  const SceneBuilder faint = lit_ball(mirror);
  EXPECT_EQ(Explainer(faint.scene, faint.assets, default_options(Profile::fine))
                .explain(512, 384)
                .rays[0]
                .mirror.outcome,
            BranchOutcome::too_faint);
}

TEST(Explain, TotalReflectionHasAWall) {
  // A glass cube, entered at an angle through its front; the side wall reflects totally.
  RenderMaterial glass;
  glass.transparent = glm::vec3(1);
  glass.ior = 1.5f;
  SceneBuilder b;
  b.add(Shape::cube, translate({0, 0, -5}) * scale(glm::vec3(2)), b.material(glass));
  b.look({1.4, 0, -1}, {-0.8, 0, -4});
  const PixelRecord pixel = middle(b);
  ASSERT_EQ(pixel.rays.size(), 2u);
  EXPECT_EQ(pixel.rays[1].kind, RayKind::refracted);
  ASSERT_GE(pixel.rays[1].walls.size(), 1u);
  EXPECT_TRUE(pixel.rays[1].walls[0].mirrored);
}

TEST(Explain, AnySampleCanBeShown) {
  RenderMaterial white;
  white.ambient = glm::vec3(1);
  SceneBuilder b = lit_ball(white);
  b.look({0, 0, 0}, {0, 0, -5}, 60);
  RenderOptions options = default_options(Profile::course);
  options.features.super_sample = true;
  options.width = options.height = 20;
  const Explainer explainer(b.scene, b.assets, options);
  const PixelRecord pixel = explainer.explain(6, 10);
  ASSERT_GT(pixel.samples.size(), 4u) << "an edge gets more samples";
  EXPECT_FALSE(pixel.samples[pixel.shown].refined);
  for (std::uint32_t i = 0; i < pixel.samples.size(); ++i) {
    EXPECT_EQ(explainer.explain(6, 10, i).shown, i);
  }
  EXPECT_EQ(explainer.explain(6, 10, 99999).shown, pixel.shown);
}

}  // namespace
}  // namespace scenefile::trace_test
