#include "builders.h"
#include "expect_near.h"
#include "scenefile/scene/prepare.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace scenefile;
using scenefile::test::expect_near;

namespace {

RenderCamera ready(const std::optional<Camera>& camera) {
  Scene scene;
  scene.camera = camera;
  return prepare(scene, Limits{}).scene.camera;
}

void expect_frame(const RenderCamera& c) {
  for (const glm::dvec3& axis : {c.u, c.v, c.w}) {
    EXPECT_NEAR(glm::length(axis), 1, 1e-12);
  }
  expect_near(glm::cross(c.u, c.v), c.w);
}

}  // namespace

TEST(PrepareCamera, AbsentMeansTheDefault) {
  const RenderCamera c = ready(std::nullopt);
  EXPECT_EQ(c, ready(Camera{}));
  EXPECT_EQ(c.position, glm::dvec3(5, 5, 5));
  expect_near(c.w, glm::dvec3(1, 1, 1) / std::sqrt(3.0));
  EXPECT_NEAR(c.fov_y, 0.7853981633974483, 1e-15);
  expect_frame(c);
}

TEST(PrepareCamera, LooksDownNegativeZWithXToTheRight) {
  Camera camera;
  camera.look = {0, 0, -4};
  camera.up = {0, 3, -1};
  const RenderCamera c = ready(camera);
  expect_near(c.u, {1, 0, 0});
  expect_near(c.v, {0, 1, 0});
  expect_near(c.w, {0, 0, 1});
}

TEST(PrepareCamera, TinyAndHugeDirectionsAreFine) {
  Camera camera;
  camera.look = {0, 0, -1e-30f};
  camera.up = {0, 1e30f, 0};
  expect_near(ready(camera).u, {1, 0, 0});
  expect_frame(ready(camera));
}

TEST(PrepareCamera, LensValuesPassAndNegativeOnesDoNot) {
  Camera camera;
  camera.aperture = 0.5f;
  camera.focal_length = 9;
  EXPECT_EQ(ready(camera).aperture, 0.5);
  EXPECT_EQ(ready(camera).focal_length, 9);
  camera.aperture = -1;
  camera.focal_length = -1;
  EXPECT_EQ(ready(camera).aperture, 0);
  EXPECT_EQ(ready(camera).focal_length, 0);
}

TEST(PrepareCamera, IsSafeWhereCheckFindsErrors) {
  Camera camera;
  camera.look = {0, 0, 0};
  camera.height_angle_deg = -10;
  expect_frame(ready(camera));
  EXPECT_GT(ready(camera).fov_y, 0);
  for (const glm::vec3 up : {glm::vec3(0), glm::vec3(0, 1, 0), glm::vec3(0, -2, 0)}) {
    camera.look = {0, 1, 0};
    camera.up = up;
    expect_frame(ready(camera));
  }
}
