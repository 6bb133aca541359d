// The lighting equation in the shader, with values computed by hand.

#include "view/build_scene.h"

#include <cmath>

namespace scenefile {

namespace {

using namespace view_test;

// A white wall of 20 x 20 at z = -4, seen head-on: one pixel is 1/32 of the view.
SceneBuilder wall() {
  SceneBuilder builder;
  RenderMaterial white;
  builder.scene.materials.push_back(white);
  builder.add(Shape::cube, place({0, 0, -14}, 20), 0);
  return builder;
}

RenderLight light(LightType type, const glm::vec3& position) {
  RenderLight l;
  l.type = type;
  l.position = position;
  l.direction = {0, 0, -1};
  return l;
}

class Lit : public Drawn {
 protected:
  // The red value at the center of the picture.
  float middle(const SceneBuilder& builder, DrawOptions options = {}) {
    options.samples = 1;
    Drawing drawing = uploaded(builder);
    return at(draw_square(drawing, builder.scene.camera, options, 33), 16, 16).r;
  }
};

constexpr float step = 1.01f / 255;

TEST_F(Lit, DirectionalLightFallsByTheCosine) {
  SceneBuilder builder = wall();
  builder.scene.lights.push_back(light(LightType::directional, {}));
  builder.scene.lights[0].direction = glm::normalize(glm::vec3(0, -1, -1));
  EXPECT_NEAR(middle(builder), std::sqrt(0.5), step);
}

TEST_F(Lit, PointLightFadesWithDistance) {
  SceneBuilder builder = wall();
  builder.scene.lights.push_back(light(LightType::point, {0, 0, 0}));
  builder.scene.lights[0].attenuation = {0.5f, 0.25f, 0.0625f};
  EXPECT_NEAR(middle(builder), 1 / 2.5, step);
  builder.scene.lights[0].attenuation = {0.5f, 0, 0};
  EXPECT_NEAR(middle(builder), 1, step) << "it never grows";
}

TEST_F(Lit, SpotlightFadesBetweenItsAngles) {
  SceneBuilder builder = wall();
  builder.scene.lights.push_back(light(LightType::spot, {0, 0, 0}));
  RenderLight& spot = builder.scene.lights[0];
  spot.inner_angle = 0;
  spot.outer_angle = 1;
  spot.direction = {std::sin(0.5f), 0, -std::cos(0.5f)};
  EXPECT_NEAR(middle(builder), 0.5, step);
  spot.direction = {std::sin(1.1f), 0, -std::cos(1.1f)};
  EXPECT_EQ(middle(builder), 0);
}

TEST_F(Lit, AreaLightShinesToOneSide) {
  SceneBuilder builder = wall();
  builder.scene.lights.push_back(light(LightType::area, {0, 0, 0}));
  RenderLight& area = builder.scene.lights[0];
  area.half_u = {0.01f, 0, 0};
  area.half_v = {0, 0.01f, 0};
  EXPECT_NEAR(middle(builder), 1, step);
  area.direction = {0, 0, 1};
  EXPECT_EQ(middle(builder), 0);
}

TEST_F(Lit, HighlightIsInTheMirrorDirection) {
  SceneBuilder builder = wall();
  builder.scene.materials[0].diffuse = glm::vec3(0);
  builder.scene.materials[0].specular = glm::vec3(0.5f);
  builder.scene.materials[0].shininess = 20;
  builder.scene.lights.push_back(light(LightType::directional, {}));
  EXPECT_NEAR(middle(builder), 0.5, step);
  builder.scene.lights[0].direction = {std::sin(0.3f), 0, -std::cos(0.3f)};
  EXPECT_NEAR(middle(builder), 0.5 * std::pow(std::cos(0.3), 20), step);
  builder.scene.materials[0].shininess = 0;
  EXPECT_EQ(middle(builder), 0) << "no shininess, no highlight";
}

TEST_F(Lit, LightsAreSwitched) {
  SceneBuilder builder = wall();
  builder.scene.lights = {light(LightType::directional, {}), light(LightType::point, {0, 0, 0})};
  builder.scene.lights[0].color = glm::vec3(0.25f);
  builder.scene.lights[1].color = glm::vec3(0.5f);
  DrawOptions options;
  EXPECT_NEAR(middle(builder, options), 0.75, step);
  options.lights = {false};
  EXPECT_NEAR(middle(builder, options), 0.5, step);
  options.lights = {};
  options.directional_only = true;
  EXPECT_NEAR(middle(builder, options), 0.25, step);
}

TEST_F(Lit, OccludersCastShadows) {
  for (const LightType type :
       {LightType::directional, LightType::point, LightType::spot, LightType::area}) {
    SceneBuilder builder = wall();
    RenderLight l = light(type, {0, 3, -1});
    l.direction = glm::normalize(glm::vec3(0, -1, -1));
    l.inner_angle = l.outer_angle = 0.6f;
    l.half_u = {0.01f, 0, 0};
    l.half_v = {0, 0.007f, 0.007f};
    builder.scene.lights = {l};
    DrawOptions options;
    const float lit = middle(builder, options);
    EXPECT_GT(lit, 0.5) << static_cast<int>(type);
    builder.add(Shape::sphere, place({0, 1.5f, -2.5f}), 0);
    EXPECT_EQ(middle(builder, options), 0) << static_cast<int>(type);
    options.shadows = false;
    EXPECT_EQ(middle(builder, options), lit) << static_cast<int>(type);
  }
}

TEST_F(Lit, TransparentObjectsTintWhatIsBehind) {
  SceneBuilder builder = wall();
  builder.scene.lights.push_back(light(LightType::directional, {}));
  RenderMaterial glass;
  glass.diffuse = glm::vec3(0);
  glass.ambient = glm::vec3(0.125f);
  glass.transparent = glm::vec3(0.5f);
  builder.scene.materials.push_back(glass);
  builder.add(Shape::sphere, place({0, 0, -2}), 1);
  builder.add(Shape::sphere, place({0, 0, -3}, 0.5f), 1);
  DrawOptions options;
  options.shadows = false;
  EXPECT_NEAR(middle(builder, options), 0.125 + 0.5 * (0.125 + 0.5), 2 * step);
  options.transparency = false;
  EXPECT_NEAR(middle(builder, options), 0.125, step);
}

TEST_F(Lit, TheCourseTruncatesAndTheFineRounds) {
  SceneBuilder builder;
  builder.add(Shape::cube, place({0, 0, -3}), builder.glowing(glm::vec3(99.75f / 255)));
  DrawOptions options;
  EXPECT_NEAR(middle(builder, options) * 255, 100, 1e-3);
  options.course = true;
  EXPECT_NEAR(middle(builder, options) * 255, 99, 1e-3);
}

TEST_F(Lit, ATextureIsBlendedOverTheDiffuseColor) {
  SceneBuilder builder = wall();
  builder.scene.lights.push_back(light(LightType::directional, {}));
  builder.scene.texture_files.emplace_back();
  Texture texture;
  texture.width = texture.height = 1;
  texture.rgb = {51, 51, 51};
  builder.assets.textures.push_back(texture);
  builder.scene.materials[0].texture.file = 0;
  builder.scene.materials[0].blend = 0.5f;
  EXPECT_NEAR(middle(builder), 0.5 + 0.5 * 0.2, step);
  DrawOptions options;
  options.textures = false;
  EXPECT_NEAR(middle(builder, options), 1, step);
}

}  // namespace

}  // namespace scenefile
