// The lighting equation, with values computed by hand.

#include "trace/build_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scenefile::trace_test {
namespace {

constexpr double light_tolerance = 1e-6;

// The top of the unit cube at y = 0, seen from directly above.
SceneBuilder floor_scene(const RenderMaterial& material) {
  SceneBuilder b;
  const std::uint32_t m = b.material(material);
  b.add(Shape::cube, Affine{glm::mat3(10), glm::vec3(0, -5, 0)}, m);
  b.look({0, 3, 0}, {0, 0, 0});
  return b;
}

RenderMaterial white() {
  return RenderMaterial{};
}

glm::vec3 slanted(double degrees) {
  const double a = glm::radians(degrees);
  return {std::sin(a), -std::cos(a), 0};
}

TEST(Lighting, DiffuseLightFollowsLambertsCosine) {
  for (const double angle : {0.0, 30.0, 60.0, 89.0}) {
    SceneBuilder b = floor_scene(white());
    b.light(LightType::directional, slanted(angle), {0.5, 0.25, 0.125});
    const double cosine = std::cos(glm::radians(angle));
    EXPECT_NEAR(b.seen().x, 0.5 * cosine, light_tolerance) << angle;
    EXPECT_NEAR(b.seen().y, 0.25 * cosine, light_tolerance) << angle;
  }
}

TEST(Lighting, CoefficientsMultiplyTheirTerms) {
  RenderMaterial m;
  m.ambient = {0.5, 0, 0};
  m.diffuse = {0, 0.5, 0};
  m.specular = {0, 0, 0.5};
  m.shininess = 10;
  SceneBuilder b = floor_scene(m);
  b.scene.global.ambient = 0.5f;
  b.scene.global.diffuse = 0.25f;
  b.scene.global.specular = 0.125f;
  b.light(LightType::directional, {0, -1, 0}, glm::vec3(1));
  const glm::dvec3 c = b.seen();
  EXPECT_NEAR(c.x, 0.25, light_tolerance);
  EXPECT_NEAR(c.y, 0.125, light_tolerance);
  EXPECT_NEAR(c.z, 0.0625, light_tolerance);
}

TEST(Lighting, AmbientLightNeedsNoLight) {
  RenderMaterial m;
  m.ambient = glm::vec3(0.25);
  EXPECT_NEAR(floor_scene(m).seen().x, 0.25, light_tolerance);
}

TEST(Lighting, PointLightsFallOffWithTheSquare) {
  SceneBuilder b = floor_scene(white());
  b.light(LightType::point, {0, 2, 0}, glm::vec3(1)).attenuation = {0, 0, 1};
  EXPECT_NEAR(b.seen().x, 1.0 / 4, light_tolerance);
  b.scene.lights[0].position.y = 2.5;
  EXPECT_NEAR(b.seen().x, 1 / 6.25, light_tolerance);
}

TEST(Lighting, AttenuationHasThreeTermsAndNeverBrightens) {
  SceneBuilder b = floor_scene(white());
  b.light(LightType::point, {0, 2, 0}, glm::vec3(1)).attenuation = {1, 0.5, 0.25};
  EXPECT_NEAR(b.seen().x, 1.0 / 3, light_tolerance);
  b.scene.lights[0].attenuation = {0.25, 0, 0};
  b.scene.lights[0].color = glm::vec3(0.5);
  EXPECT_NEAR(b.seen().x, 0.5, light_tolerance);
}

TEST(Lighting, DirectionalLightsDoNotFallOff) {
  SceneBuilder b = floor_scene(white());
  b.light(LightType::directional, {0, -1, 0}, glm::vec3(0.5)).attenuation = {100, 100, 100};
  EXPECT_NEAR(b.seen().x, 0.5, light_tolerance);
}

TEST(Lighting, HighlightIsTheCosineToTheMirrorDirectionToThePowerOfShininess) {
  RenderMaterial m;
  m.diffuse = glm::vec3(0);
  m.specular = glm::vec3(1);
  for (const float shininess : {1.0f, 5.0f, 40.0f}) {
    m.shininess = shininess;
    SceneBuilder b = floor_scene(m);
    b.light(LightType::directional, slanted(20), glm::vec3(1));
    const double expected = std::pow(std::cos(glm::radians(20.0)), shininess);
    EXPECT_NEAR(b.seen().x, expected, light_tolerance) << shininess;
  }
}

TEST(Lighting, NoShininessNoHighlight) {
  RenderMaterial m;
  m.diffuse = glm::vec3(0);
  m.specular = glm::vec3(1);
  SceneBuilder b = floor_scene(m);
  b.light(LightType::directional, {0, -1, 0}, glm::vec3(1));
  EXPECT_EQ(b.seen().x, 0);
}

TEST(Lighting, LightsBehindTheSurfaceDoNotCount) {
  SceneBuilder b = floor_scene(white());
  b.light(LightType::directional, {0, 1, 0}, glm::vec3(1));
  EXPECT_EQ(b.seen().x, 0);
}

TEST(Lighting, MoreThanEightLightsCount) {
  SceneBuilder b = floor_scene(white());
  for (int i = 0; i < 12; ++i) {
    b.light(LightType::directional, {0, -1, 0}, glm::vec3(0.0625));
  }
  EXPECT_NEAR(b.seen().x, 0.75, light_tolerance);
}

SceneBuilder spot_scene(double degrees) {
  SceneBuilder b = floor_scene(white());
  RenderLight& light = b.light(LightType::spot, {0, 2, 0}, glm::vec3(1));
  light.inner_angle = glm::radians(10.0f);
  light.outer_angle = glm::radians(30.0f);
  light.direction = slanted(degrees);
  return b;
}

TEST(Lighting, SpotsFadeAsASmoothstepOfTheAngle) {
  EXPECT_NEAR(spot_scene(0).seen().x, 1, light_tolerance);
  EXPECT_NEAR(spot_scene(9.9).seen().x, 1, light_tolerance);
  EXPECT_NEAR(spot_scene(15).seen().x, 1 - (3.0 / 16 - 2.0 / 64), light_tolerance);
  EXPECT_NEAR(spot_scene(20).seen().x, 0.5, light_tolerance);
  EXPECT_NEAR(spot_scene(25).seen().x, 1 - (3 * 9.0 / 16 - 2 * 27.0 / 64), light_tolerance);
  EXPECT_EQ(spot_scene(30.1).seen().x, 0);
}

TEST(Lighting, SpotWithoutPenumbraHasASharpEdge) {
  SceneBuilder b = spot_scene(19.9);
  b.scene.lights[0].inner_angle = b.scene.lights[0].outer_angle = glm::radians(20.0f);
  EXPECT_NEAR(b.seen().x, 1, light_tolerance);
  b.scene.lights[0].direction = slanted(20.1);
  EXPECT_EQ(b.seen().x, 0);
}

RenderLight& area_light(SceneBuilder& b) {
  RenderLight& light = b.light(LightType::area, {0, 2, 0}, glm::vec3(1));
  light.direction = {0, -1, 0};
  light.half_u = {0.5, 0, 0};
  light.half_v = {0, 0, 0.5};
  light.attenuation = {0, 0, 1};
  return light;
}

// The mean of cosine / distance^2 over a square of side 1 at height 2, on a fine grid.
double area_light_answer() {
  double sum = 0;
  constexpr int n = 400;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double x = (i + 0.5) / n - 0.5;
      const double z = (j + 0.5) / n - 0.5;
      const double d2 = x * x + z * z + 4;
      sum += 2 / std::sqrt(d2) / d2;
    }
  }
  return sum / (n * n);
}

TEST(Lighting, AreaLightsAreTheMeanOverTheirFace) {
  SceneBuilder b = floor_scene(white());
  area_light(b);
  EXPECT_NEAR(b.seen().x, area_light_answer(), 1e-3);
  EXPECT_NEAR(b.seen(Profile::fine).x, area_light_answer(), 5e-3);
}

TEST(Lighting, AreaLightsShineToTheFrontOnly) {
  SceneBuilder b = floor_scene(white());
  area_light(b).direction = {0, 1, 0};
  EXPECT_EQ(b.seen().x, 0);
}

TEST(Lighting, TextureReplacesTheDiffuseColorByItsBlend) {
  RenderMaterial m;
  m.diffuse = glm::vec3(1);
  m.blend = 0.25;
  m.texture.file = 0;
  SceneBuilder b = floor_scene(m);
  b.scene.global.diffuse = 0.5f;
  b.texture(1, 1, {51});
  b.light(LightType::directional, slanted(60), glm::vec3(1));
  for (const Profile profile : {Profile::course, Profile::fine}) {
    // The diffuse coefficient does not apply to the texture.
    EXPECT_NEAR(b.seen(profile).x, 0.5 * (0.75 * 0.5 + 0.25 * 0.2), light_tolerance);
  }
  RenderOptions off = default_options(Profile::course);
  off.features.texture = false;
  EXPECT_NEAR(b.seen(off).x, 0.25, light_tolerance);
}

TEST(Lighting, MissingTextureShadesWithTheDiffuseColor) {
  RenderMaterial m;
  m.blend = 1;
  m.texture.file = 0;
  SceneBuilder b = floor_scene(m);
  b.texture(0, 0, {});
  b.light(LightType::directional, {0, -1, 0}, glm::vec3(0.5));
  EXPECT_NEAR(b.seen(Profile::course).x, 0.5, light_tolerance);
  EXPECT_NEAR(b.seen(Profile::fine).x, 0.5, light_tolerance);
}

TEST(Lighting, CourseIntersectModeUsesOnlyDirectionalLights) {
  SceneBuilder b = floor_scene(white());
  b.light(LightType::point, {0, 2, 0}, glm::vec3(0.25));
  b.light(LightType::directional, {0, -1, 0}, glm::vec3(0.5));
  EXPECT_NEAR(b.seen(Profile::course, Mode::intersect).x, 0.5, light_tolerance);
  EXPECT_NEAR(b.seen(Profile::fine, Mode::intersect).x, 0.75, light_tolerance);
}

TEST(Lighting, IntersectModeHasNoShadowsReflectionsOrTextures) {
  RenderMaterial m;
  m.reflective = glm::vec3(1);
  m.texture.file = 0;
  m.blend = 1;
  SceneBuilder b = floor_scene(m);
  b.texture(1, 1, {0});
  b.add(Shape::cube, translate({0, 6, 0}), b.glowing({0, 1, 0}));
  b.light(LightType::directional, {0, -1, 0}, glm::vec3(0.5));
  for (const Profile profile : {Profile::course, Profile::fine}) {
    EXPECT_NEAR(b.seen(profile, Mode::intersect).x, 0.5, light_tolerance);
    EXPECT_NEAR(b.seen(profile, Mode::intersect).y, 0.5, light_tolerance);
  }
}

// A triangle around the origin, facing up, with normals tilted toward +x.
Mesh leaning_triangle() {
  Mesh m;
  m.positions = {{-5, 0, 5}, {5, 0, 5}, {0, 0, -5}};
  m.triangles = {{0, 1, 2}};
  m.normals = {{0.6f, 0.8f, 0}};
  m.triangle_normals = {{0, 0, 0}};
  return m;
}

TEST(Lighting, MeshesAreFlatInTheCourseAndSmoothInFine) {
  SceneBuilder b;
  const std::uint32_t m = b.material(white());
  RenderPrimitive p = b.primitive(Shape::mesh, Affine(), m);
  p.mesh = b.mesh(leaning_triangle());
  b.scene.groups[0].primitives.push_back(p);
  b.look({0, 3, 0}, {0, 0, 0});
  b.light(LightType::directional, {0, -1, 0}, glm::vec3(0.5));
  EXPECT_NEAR(b.seen(Profile::course).x, 0.5, light_tolerance);
  EXPECT_NEAR(b.seen(Profile::fine).x, 0.4, light_tolerance);
}

}  // namespace
}  // namespace scenefile::trace_test
