#include "scenefile/scene/camera_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace scenefile {
namespace {

CameraView view(double time, glm::vec3 position, std::optional<glm::vec3> focus = {}) {
  CameraView v;
  v.time = time;
  v.camera.position = position;
  v.focus = focus;
  if (focus) {
    v.camera.look = *focus - position;
  }
  return v;
}

std::vector<CameraView> some_views(bool with_focus) {
  std::vector<CameraView> views;
  for (int i = 0; i < 5; ++i) {
    const glm::vec3 place(5 * std::cos(i), 1 + 0.3f * float(i), 5 * std::sin(i));
    views.push_back(view(i + 0.2 * i * i, place, glm::vec3(0)));
    views.back().camera.height_angle_deg = i == 2 ? 20.0f : 50.0f;
    if (!with_focus) {
      views.back().focus.reset();
    }
  }
  return views;
}

TEST(CameraPath, GoesThroughTheViews) {
  for (const bool with_focus : {true, false}) {
    const std::vector<CameraView> views = some_views(with_focus);
    for (const CameraView& v : views) {
      EXPECT_EQ(camera_at(views, v.time), v.camera);
    }
    EXPECT_EQ(camera_at(views, -7), views.front().camera);
    EXPECT_EQ(camera_at(views, 99), views.back().camera);
  }
}

// Position and direction change by about as much in two consecutive short steps.
TEST(CameraPath, NeitherPlaceNorSpeedJumps) {
  constexpr double step = 1e-2;
  for (const bool with_focus : {true, false}) {
    const std::vector<CameraView> views = some_views(with_focus);
    for (double t = step; t < views.back().time - 2 * step; t += step) {
      const Camera a = camera_at(views, t);
      const Camera b = camera_at(views, t + step);
      const Camera c = camera_at(views, t + 2 * step);
      EXPECT_LT(glm::distance(a.position, b.position), 0.15f);
      EXPECT_LT(glm::distance(b.position - a.position, c.position - b.position), 0.01f) << t;
      const auto direction = [](const Camera& camera) { return glm::normalize(camera.look); };
      EXPECT_LT(glm::distance(direction(a), direction(b)), 0.06f) << t;
      EXPECT_LT(glm::distance(direction(b) - direction(a), direction(c) - direction(b)), 0.005f)
          << t;
      EXPECT_GE(b.height_angle_deg, 20 - 1e-3f);
      EXPECT_LE(b.height_angle_deg, 50 + 1e-3f);
    }
  }
}

TEST(CameraPath, LooksAtTheFocus) {
  const std::vector<CameraView> views = some_views(true);
  for (double t = 0; t < views.back().time; t += 0.1) {
    const Camera camera = camera_at(views, t);
    EXPECT_LT(
        glm::length(glm::cross(glm::normalize(camera.look), glm::normalize(-camera.position))),
        1e-5f);
  }
}

TEST(CameraPath, TurnsAroundAPoint) {
  Camera camera;
  camera.position = {0, 2, 5};
  camera.look = {0, -2, -5};
  EXPECT_EQ(camera_around(camera, {0, 0, 0}, 0), camera);
  const Camera quarter = camera_around(camera, {0, 0, 0}, 0.25);
  EXPECT_NEAR(quarter.position.x, 5, 1e-5);
  EXPECT_NEAR(quarter.position.y, 2, 1e-5);
  EXPECT_NEAR(quarter.position.z, 0, 1e-5);
  EXPECT_NEAR(quarter.look.x, -5, 1e-5);
  EXPECT_EQ(quarter.up, camera.up);
}

TEST(CameraKey, DiffersWithEveryValue) {
  std::vector<Camera> cameras(9);
  cameras[1].position.z += 1e-6F;
  cameras[2].look.x = 3;
  cameras[3].up.x = 1e-30F;
  cameras[4].height_angle_deg = 46;
  cameras[5].aperture = 1;
  cameras[6].focal_length = 1;
  cameras[7].position = {5, 5, -5};
  cameras[8].look = {-1, -1, 1};
  cameras[0].location.line = 7;  // says nothing about the picture
  std::set<std::string> keys;
  for (const Camera& camera : cameras) {
    keys.insert(camera_key(camera));
  }
  EXPECT_EQ(keys.size(), cameras.size());
  EXPECT_EQ(camera_key(cameras[0]), camera_key(Camera{}));
}

}  // namespace
}  // namespace scenefile
