#include "scenefile/explain/remarks.h"

#include "trace/build_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace scenefile {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::Not;
using trace_test::scale;
using trace_test::SceneBuilder;
using trace_test::translate;

using Names = std::multiset<std::string_view>;

// The remarks about the center pixel.
Names said(const SceneBuilder& b, RenderOptions options = default_options(Profile::course)) {
  options.width = options.height = 1;
  options.samples = 1;
  const PixelRecord pixel = Explainer(b.scene, b.assets, options).explain(0, 0);
  Names names;
  for (const Remark& remark : remarks(b.scene, pixel)) {
    EXPECT_FALSE(remark.text.empty());
    names.insert(remark_name(remark.kind));
  }
  return names;
}

RenderOptions fine() {
  return default_options(Profile::fine);
}

RenderMaterial gray() {
  RenderMaterial m;
  m.diffuse = glm::vec3(0.5f);
  return m;
}

// A sphere in front of the camera, and a light next to the camera.
SceneBuilder ball(const RenderMaterial& m) {
  SceneBuilder b;
  b.add(Shape::sphere, translate({0, 0, -5}) * scale(glm::vec3(2)), b.material(m));
  b.light(LightType::point, {1, 1, 0}, glm::vec3(1));
  return b;
}

TEST(Remarks, NothingToSay) {
  EXPECT_THAT(said(ball(gray())), IsEmpty());
  EXPECT_THAT(said(SceneBuilder()), IsEmpty());
}

TEST(Remarks, Clamped) {
  RenderMaterial m = gray();
  m.ambient = glm::vec3(1.01f);
  EXPECT_THAT(said(ball(m)), Contains("clamped"));
  EXPECT_THAT(said(ball(m), fine()), Contains("clamped"));
  m.ambient = glm::vec3(0.4f);
  EXPECT_THAT(said(ball(m)), Not(Contains("clamped")));
}

TEST(Remarks, SeenFromBehind) {
  SceneBuilder b = ball(gray());
  b.look({0, 0, -5}, {0, 0, -6});
  EXPECT_THAT(said(b), Contains("seen-from-behind"));
}

TEST(Remarks, NormalPastTheHorizon) {
  Mesh m;
  m.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  m.triangles = m.triangle_normals = {{0, 1, 2}};
  m.normals = {{0, 0, -1}, {0, 0, -1}, {0, 0, -1}};
  SceneBuilder b;
  b.add(Shape::mesh, translate({0, 0, -5}), b.material(gray()));
  b.scene.groups[0].primitives[0].mesh = b.mesh(m);
  EXPECT_THAT(said(b, fine()), Contains("normal-past-horizon"));
  EXPECT_THAT(said(b), Not(Contains("normal-past-horizon"))) << "the course takes the triangle's";
}

TEST(Remarks, NoShininess) {
  RenderMaterial m = gray();
  m.specular = glm::vec3(0.5f);
  EXPECT_THAT(said(ball(m)), Contains("no-shininess"));
  m.shininess = 5;
  EXPECT_THAT(said(ball(m)), Not(Contains("no-shininess")));
}

TEST(Remarks, TexturesThatAreNotSeen) {
  SceneBuilder b = ball(gray());
  RenderMaterial& m = b.scene.materials[0];
  m.texture.file = b.texture(1, 1, {9});
  EXPECT_THAT(said(b), Contains("texture-hidden"));
  m.blend = 0.5f;
  EXPECT_THAT(said(b), IsEmpty());
  b.assets.textures[0] = {};
  EXPECT_THAT(said(b), Contains("texture-missing"));
  RenderOptions options = default_options(Profile::course);
  options.features.texture = false;
  EXPECT_THAT(said(b, options), IsEmpty());
}

TEST(Remarks, NoTransparentShare) {
  RenderMaterial m = gray();
  m.transparent = glm::vec3(0.5f);
  SceneBuilder b = ball(m);
  b.scene.global.transparent.reset();
  EXPECT_THAT(said(b), Contains("no-transparent-share"));
  b.scene.global.transparent = 0.1f;
  EXPECT_THAT(said(b), Not(Contains("no-transparent-share")));
}

TEST(Remarks, TotalReflectionAndTrapped) {
  RenderMaterial m = gray();
  m.transparent = glm::vec3(1);
  m.ior = 1.5f;
  SceneBuilder b;
  b.add(Shape::cube, translate({0, 0, -5}) * scale(glm::vec3(2)), b.material(m));
  b.look({1.4, 0, -1}, {-0.8, 0, -4});
  EXPECT_THAT(said(b), Contains("total-reflection"));
  EXPECT_THAT(said(b), Not(Contains("trapped")));
  RenderOptions options = default_options(Profile::course);
  options.max_depth = 1;
  EXPECT_THAT(said(b, options), Contains("trapped"));
  b.look({0, 0, 0}, {0, 0, -5});
  EXPECT_THAT(said(b), Not(Contains("total-reflection")));
}

TEST(Remarks, RaysThatAreNotFollowed) {
  RenderMaterial m = gray();
  m.reflective = glm::vec3(0.0005f);
  EXPECT_THAT(said(ball(m), fine()), Contains("too-faint"));
  EXPECT_THAT(said(ball(m)), Not(Contains("too-faint")));
  RenderOptions options = default_options(Profile::course);
  options.max_depth = 0;
  EXPECT_THAT(said(ball(m), options), Contains("too-deep"));
}

TEST(Remarks, LightBehindTheSurface) {
  SceneBuilder b = ball(gray());
  b.scene.lights[0].position = {0, 0, -9};
  EXPECT_THAT(said(b), Contains("light-behind"));
}

TEST(Remarks, HighlightFromBehind) {
  // A light slightly below the horizon of a wall seen at an angle.
  RenderMaterial m = gray();
  m.specular = glm::vec3(1);
  m.shininess = 1;
  SceneBuilder b;
  b.add(Shape::cube, translate({0, -1, 0}) * scale({9, 2, 9}), b.material(m));
  b.look({-3, 1, 0}, {0, 0, 0});
  b.light(LightType::point, {4, -0.1f, 0}, glm::vec3(1));
  EXPECT_THAT(said(b), Contains("highlight-from-behind"));
  b.scene.lights[0].position = {4, 0.1f, 0};
  EXPECT_THAT(said(b), Not(Contains("highlight-from-behind")));
}

TEST(Remarks, ShadowByItself) {
  // A tent of two triangles, one of which shadows the other.
  Mesh m;
  m.positions = {{-2, -2, 0}, {2, -2, 0}, {0, 2, 0}, {0.5f, -2, 0}, {0.5f, -2, 2}, {0.5f, 2, 1}};
  m.triangles = {{0, 1, 2}, {3, 4, 5}};
  SceneBuilder b;
  b.add(Shape::mesh, translate({0, 0, -5}), b.material(gray()));
  b.scene.groups[0].primitives[0].mesh = b.mesh(m);
  b.light(LightType::point, {4, 0, 1.4f}, glm::vec3(1));
  EXPECT_THAT(said(b), Contains("shadow-by-itself"));
  b.scene.lights[0].position = {-4, 0, -3};
  EXPECT_THAT(said(b), IsEmpty());
}

// The tracer has no shadow acne on solids, so the record is changed to show some.
TEST(Remarks, ShadowAcne) {
  const SceneBuilder b = ball(gray());
  RenderOptions options = default_options(Profile::course);
  options.width = options.height = 1;
  PixelRecord pixel = Explainer(b.scene, b.assets, options).explain(0, 0);
  LightSample& light = pixel.rays[0].lights[0].samples[0];
  light.visibility = Color(0);
  light.blockers = {{pixel.rays[0].surface->object, 0.002, Color(0), true}};
  EXPECT_EQ(remarks(b.scene, pixel).at(0).kind, RemarkKind::shadow_acne);
  light.blockers[0].itself = false;
  EXPECT_THAT(remarks(b.scene, pixel), IsEmpty());
}

TEST(Remarks, LightsWithoutContribution) {
  SceneBuilder b = ball(gray());
  b.scene.lights[0].attenuation = {1000, 0, 0};
  EXPECT_THAT(said(b), Contains("light-faded"));
  RenderLight& light = b.scene.lights[0];
  light.attenuation = {1, 0, 0};
  light.type = LightType::spot;
  light.direction = {0, 1, 0};
  light.inner_angle = light.outer_angle = 0.3f;
  EXPECT_THAT(said(b), Contains("light-out-of-reach"));
  light.direction = glm::normalize(glm::vec3(-1, -1, -4));
  EXPECT_THAT(said(b), IsEmpty());
  RenderOptions caster = default_options(Profile::course);
  caster.mode = Mode::intersect;
  EXPECT_THAT(said(b, caster), Contains("light-of-another-mode"));
}

TEST(Remarks, SayHowFarOutsideTheConeAPointIs) {
  SceneBuilder b = ball(gray());
  RenderLight& light = b.scene.lights[0];
  light.type = LightType::spot;
  light.position = {0, 0, 0};
  light.direction = {1, 0, 0};
  light.inner_angle = light.outer_angle = glm::radians(20.0f);
  RenderOptions options = default_options(Profile::course);
  options.width = options.height = 1;
  const PixelRecord pixel = Explainer(b.scene, b.assets, options).explain(0, 0);
  EXPECT_EQ(remarks(b.scene, pixel).at(0).text,
            "outside the cone of the spotlight: 90 degrees from its axis, light ends at 20");
}

TEST(Remarks, NormalsHaveNone) {
  RenderOptions options = default_options(Profile::course);
  options.mode = Mode::normals;
  SceneBuilder b = ball(gray());
  b.look({0, 0, -5}, {0, 0, -6});
  EXPECT_THAT(said(b, options), IsEmpty());
}

}  // namespace
}  // namespace scenefile
