#include "builders.h"
#include "scenefile/scene/prepare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace scenefile;
using namespace scenefile::test;

namespace {

using std::numbers::pi;

std::vector<RenderLight> lights_of(const Scene& scene, std::uint32_t limit = 1024) {
  Limits limits;
  limits.lights = limit;
  return prepare(scene, limits).scene.lights;
}

RenderLight placed(const Light& light, std::vector<Transform> transforms = {}) {
  Scene scene;
  scene.nodes[add_group(scene, 0, std::move(transforms))].lights = {light};
  const std::vector<RenderLight> lights = lights_of(scene);
  EXPECT_EQ(lights.size(), 1u);
  return lights.empty() ? RenderLight{} : lights[0];
}

Light light_of(LightType type, glm::vec3 direction) {
  Light light;
  light.type = type;
  light.direction = direction;
  return light;
}

void expect_near(glm::vec3 a, glm::vec3 b) {
  EXPECT_LT(glm::length(a - b), 1e-6f) << a.x << ' ' << a.y << ' ' << a.z;
}

}  // namespace

TEST(PrepareLights, PositionTakesTheWholeMap) {
  expect_near(placed(point_light({1, 0, 0}), {translate(0, 5, 0), scale(2, 2, 2)}).position,
              {2, 5, 0});
}

TEST(PrepareLights, DirectionTakesTheLinearPartAndUnitLength) {
  const Light sun = light_of(LightType::directional, {0, -7, 0});
  expect_near(placed(sun, {translate(9, 9, 9), rotate({0, 0, 1}, 90), scale(5, 5, 5)}).direction,
              {1, 0, 0});
}

TEST(PrepareLights, AMirrorTurnsADirection) {
  const Light sun = light_of(LightType::directional, {0, -1, 0});
  expect_near(placed(sun, {scale(1, -1, 1)}).direction, {0, 1, 0});
}

TEST(PrepareLights, ValuesThatATypeDoesNotUseDoNotMatter) {
  Light sun = light_of(LightType::directional, {0, -1, 0});
  const RenderLight plain = placed(sun);
  sun.position = {4, 4, 4};
  sun.attenuation = {3, 3, 3};
  sun.angle_deg = 10.0f;
  sun.width = 5;
  EXPECT_EQ(placed(sun), plain);
}

TEST(PrepareLights, SpotAngles) {
  Light spot = light_of(LightType::spot, {0, -1, 0});
  const auto angles = [&](std::optional<float> angle, float penumbra) {
    spot.angle_deg = angle;
    spot.penumbra_deg = penumbra;
    const RenderLight light = placed(spot);
    return std::pair(light.inner_angle / pi * 180, light.outer_angle / pi * 180);
  };
  const auto expect = [](std::pair<double, double> got, double inner, double outer) {
    EXPECT_NEAR(got.first, inner, 1e-5);
    EXPECT_NEAR(got.second, outer, 1e-5);
  };
  expect(angles(30.0f, 10), 20, 30);
  expect(angles(30.0f, 0), 30, 30);
  expect(angles(30.0f, 50), 0, 30);
  expect(angles(std::nullopt, 20), 0, 20);
  expect(angles(std::nullopt, 0), 0, 0);
  expect(angles(30.0f, -10), 30, 30);
  expect(angles(-5.0f, 0), 0, 0);
  expect(angles(500.0f, 0), 180, 180);
}

TEST(PrepareLights, AttenuationThatDividesByZeroIsNone) {
  Light light = point_light();
  light.attenuation = {0, 0, 0};
  EXPECT_EQ(placed(light).attenuation, glm::vec3(1, 0, 0));
  light.attenuation = {0, 0, 1};
  EXPECT_EQ(placed(light).attenuation, glm::vec3(0, 0, 1));
  light.attenuation = {-1, 0.5f, 0};
  EXPECT_EQ(placed(light).attenuation, glm::vec3(0, 0.5f, 0));
}

TEST(PrepareLights, AreaLightHangsLevel) {
  Light area = light_of(LightType::area, {0, 0, -2});
  area.width = 4;
  area.height = 2;
  const RenderLight light = placed(area);
  expect_near(light.half_u, {2, 0, 0});
  expect_near(light.half_v, {0, 1, 0});
  expect_near(light.direction, {0, 0, -1});
}

TEST(PrepareLights, AreaLightThatShinesDown) {
  Light area = light_of(LightType::area, {0, -1, 0});
  area.width = 4;
  area.height = 2;
  const RenderLight light = placed(area);
  expect_near(light.half_u, {2, 0, 0});
  EXPECT_NEAR(std::abs(light.half_v.z), 1, 1e-6);
  expect_near(light.direction, {0, -1, 0});
}

TEST(PrepareLights, AreaLightIsTransformedAsARectangle) {
  Light area = light_of(LightType::area, {0, 0, -1});
  area.width = 2;
  area.height = 2;
  const RenderLight turned = placed(area, {rotate({0, 1, 0}, 90), scale(3, 1, 1)});
  expect_near(turned.half_u, {0, 0, -3});
  expect_near(turned.half_v, {0, 1, 0});
  expect_near(turned.direction, {-1, 0, 0});
  // A shear maps the rectangle's plane to itself, but not its normal.
  glm::mat4 shear(1);
  shear[2][0] = 1;
  const RenderLight sheared = placed(area, {matrix(shear)});
  EXPECT_NEAR(glm::dot(sheared.direction, sheared.half_u), 0, 1e-6);
  expect_near(sheared.direction, {0, 0, -1});
}

TEST(PrepareLights, EachInstanceHasItsOwnLights) {
  Scene scene;
  const NodeId lamp = add_template(scene, "lamp");
  scene.nodes[lamp].lights = {point_light({0, 1, 0})};
  const NodeId pair = add_template(scene, "pair");
  add_instance(scene, pair, "lamp", {translate(1, 0, 0)});
  add_instance(scene, pair, "lamp", {translate(2, 0, 0)});
  scene.nodes[0].lights = {point_light({0, 0, 0})};
  add_instance(scene, 0, "pair", {scale(10, 10, 10)});
  const std::vector<RenderLight> lights = lights_of(scene);
  ASSERT_EQ(lights.size(), 3u);
  expect_near(lights[0].position, {0, 0, 0});
  expect_near(lights[1].position, {10, 10, 0});
  expect_near(lights[2].position, {20, 10, 0});
  EXPECT_EQ(lights[1].source, lights[2].source);
}

TEST(PrepareLights, FlattenedSpaceKeepsItsPointLights) {
  Scene scene;
  const NodeId lamp = add_template(scene, "lamp");
  scene.nodes[lamp].lights = {point_light({1, 1, 1})};
  add_primitive(scene, lamp);
  add_instance(scene, 0, "lamp", {scale(2, 0, 2)});
  const RenderScene got = prepare(scene, Limits{}).scene;
  ASSERT_EQ(got.lights.size(), 1u);
  expect_near(got.lights[0].position, {2, 0, 2});
  EXPECT_EQ(got.groups.size(), 1u);
  EXPECT_TRUE(got.materials.empty());
}

TEST(PrepareLights, LightsWithoutDirectionOrPositionAreLeftOut) {
  Scene scene;
  scene.nodes[0].lights = {light_of(LightType::directional, {0, 0, 0}),
                           light_of(LightType::spot, {0, 0, 0}), point_light({INFINITY, 0, 0})};
  const NodeId flat = add_group(scene, 0, {scale(1, 0, 1)});
  scene.nodes[flat].lights = {light_of(LightType::directional, {0, -1, 0})};
  EXPECT_TRUE(lights_of(scene).empty());
}

TEST(PrepareLights, StopsAtTheLimit) {
  Scene scene = bomb(40, 10, false);
  scene.nodes[scene.templates[0]].lights = {point_light()};
  EXPECT_EQ(lights_of(scene, 100).size(), 100u);
  EXPECT_EQ(lights_of(scene, 0).size(), 0u);
}
