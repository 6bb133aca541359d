#include "scenefile/explain/yours.h"

#include "trace/build_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {
namespace {

using ::testing::Contains;
using ::testing::Field;
using ::testing::IsEmpty;
using ::testing::StrEq;
using trace_test::scale;
using trace_test::SceneBuilder;
using trace_test::translate;

// A shiny ball under two lights.
SceneBuilder ball() {
  RenderMaterial m;
  m.ambient = {0.3f, 0.2f, 0.1f};
  m.diffuse = {0.5f, 0.6f, 0.2f};
  m.specular = glm::vec3(0.5f);
  m.shininess = 5;
  SceneBuilder b;
  b.add(Shape::sphere, translate({0, 0, -5}) * scale(glm::vec3(2)), b.material(m));
  b.light(LightType::point, {2, 1, 0}, glm::vec3(0.5f)).attenuation = {1, 0.05f, 0};
  b.light(LightType::directional, {0.3f, -0.4f, -0.85f}, {0.2f, 0.3f, 0.4f});
  return b;
}

RenderOptions course() {
  RenderOptions options = default_options(Profile::course);
  options.width = options.height = 9;
  return options;
}

std::array<std::uint8_t, 3> value_of(const SceneBuilder& b) {
  return Explainer(b.scene, b.assets, course()).explain(4, 4).value;
}

Yours compared(const std::array<std::uint8_t, 3>& value) {
  const SceneBuilder b = ball();
  return compare_with_yours(b.scene, Explainer(b.scene, b.assets, course()).explain(4, 4), value);
}

auto names(const char* what) {
  return Contains(Field(&YoursFit::what, StrEq(what)));
}

TEST(Yours, EqualityIsReported) {
  const Yours yours = compared(value_of(ball()));
  EXPECT_TRUE(yours.equal);
  EXPECT_THAT(yours.fits, IsEmpty());
}

TEST(Yours, WithoutTheAmbientTerm) {
  SceneBuilder b = ball();
  b.scene.global.ambient = 0;
  const Yours yours = compared(value_of(b));
  EXPECT_FALSE(yours.equal);
  EXPECT_THAT(yours.fits, names("without the ambient term"));
}

TEST(Yours, WithoutALight) {
  SceneBuilder b = ball();
  b.scene.lights.pop_back();
  EXPECT_THAT(compared(value_of(b)).fits, names("without light 2 (directional), as in its shadow"));
}

TEST(Yours, WithoutAttenuation) {
  SceneBuilder b = ball();
  b.scene.lights[0].attenuation = {1, 0, 0};
  EXPECT_THAT(compared(value_of(b)).fits, names("without attenuation"));
}

TEST(Yours, BlendedReflectionsOfTheBackgroundDarken) {
  SceneBuilder b = ball();
  for (RenderMaterial& m : b.scene.materials) {
    m.reflective = glm::vec3(0.8f, 0.4f, 0.2f);
  }
  const PixelRecord pixel = Explainer(b.scene, b.assets, course()).explain(4, 4);
  std::array<std::uint8_t, 3> blended{};
  for (int c = 0; c < 3; ++c) {
    blended[c] = static_cast<std::uint8_t>(
        255 * pixel.color[c] * (1 - b.scene.global.specular * b.scene.materials[0].reflective[c]));
  }
  EXPECT_THAT(compare_with_yours(b.scene, pixel, blended).fits,
              names("with the reflection blended with the lighting, not added"));
}

TEST(Yours, SubsetsAreTheLastResort) {
  SceneBuilder b = ball();
  b.scene.global.ambient = 0;
  for (RenderMaterial& m : b.scene.materials) {
    m.specular = glm::vec3(0);
  }
  EXPECT_THAT(compared(value_of(b)).fits, names("with only these terms: diffuse"));
}

TEST(Yours, UnknownDifferencesAreNotExplained) {
  const Yours yours = compared({250, 3, 130});
  EXPECT_FALSE(yours.equal);
  EXPECT_THAT(yours.fits, IsEmpty());
}

}  // namespace
}  // namespace scenefile
