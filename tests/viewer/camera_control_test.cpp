#include "scenefile/viewer/camera_control.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace scenefile::viewer {

namespace {

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double by = 1e-9) {
  EXPECT_LT(glm::length(a - b), by)
      << a.x << " " << a.y << " " << a.z << " and " << b.x << " " << b.y << " " << b.z;
}

Camera some_camera() {
  Camera camera;
  camera.position = {1, 2, 5};
  camera.look = {0.25F, -0.5F, -2};
  camera.up = {0, 3, 0};
  camera.height_angle_deg = 40;
  camera.aperture = 0.125F;
  camera.focal_length = 3;
  return camera;
}

double distance(const ViewCamera& view) {
  return glm::length(view.pivot - view.position);
}

TEST(CameraControl, StartsAtTheScenesCamera) {
  const Camera camera = some_camera();
  const RenderCamera drawn = render_camera(view_of(camera, 7));
  expect_near(drawn.position, camera.position);
  expect_near(drawn.w, -glm::normalize(glm::dvec3(camera.look)));
  expect_near(glm::cross(drawn.v, drawn.w), drawn.u);
  EXPECT_NEAR(drawn.fov_y, 40 * std::acos(-1) / 180, 1e-12);
  EXPECT_EQ(drawn.aperture, 0.125);
  EXPECT_EQ(drawn.focal_length, 3);
  EXPECT_NEAR(distance(view_of(camera, 7)), 7, 1e-12);
}

TEST(CameraControl, UpParallelToLook) {
  Camera camera = some_camera();
  camera.look = {0, -1, 0};
  const ViewCamera view = view_of(camera, 1);
  EXPECT_LT(std::abs(glm::dot(view.up, glm::dvec3(0, 1, 0))), 0.1);
}

TEST(CameraControl, AnUnmovedCameraKeepsTheFilesValues) {
  const Camera camera = some_camera();
  EXPECT_EQ(camera_of(view_of(camera, 7), camera), camera);
}

TEST(CameraControl, SavedValuesHaveFewDigits) {
  const Camera camera = some_camera();
  const Camera saved = camera_of(zoomed(view_of(camera, 7), 0.37123456789, {0, 0, 0}), camera);
  EXPECT_EQ(saved.look, camera.look);
  EXPECT_EQ(saved.up, camera.up);
  EXPECT_EQ(saved.position, glm::vec3(0.37123F, 0.74247F, 1.85617F));
}

TEST(CameraControl, OrbitFollowsTheDrag) {
  ViewCamera view;  // at z = 5
  const ViewCamera right = orbited(view, 90, 0);
  expect_near(right.position, {-5, 0, 0});
  expect_near(right.pivot, view.pivot);
  const ViewCamera up = orbited(view, 0, 30);
  EXPECT_LT(up.position.y, -2.4);
}

TEST(CameraControl, OrbitStopsAtThePoles) {
  const ViewCamera top = orbited(ViewCamera{}, 0, -500);
  EXPECT_GT(top.position.y, 4.9);
  const ViewAxes axes = axes_of(top);
  EXPECT_LT(axes.above.z, -0.9);
  EXPECT_NEAR(axes.right.x, 1, 1e-9);
}

TEST(CameraControl, LookingAroundKeepsThePosition) {
  const ViewCamera view = turned(ViewCamera{}, 90, 0);
  expect_near(view.position, {0, 0, 5});
  expect_near(axes_of(view).ahead, {1, 0, 0});
}

TEST(CameraControl, ThePictureFollowsThePointer) {
  ViewCamera view;
  view.height_angle_deg = 90;  // the picture is 10 units high at the pivot
  const ViewCamera panned_view = panned(view, 0.1, 0.2);
  expect_near(panned_view.pivot, {-1, -2, 0});
}

TEST(CameraControl, ZoomMovesTowardThePointer) {
  const ViewCamera view = zoomed(ViewCamera{}, 0.5, {1, 0, 0});
  expect_near(view.position, {0.5, 0, 2.5});
  expect_near(axes_of(view).ahead, {0, 0, -1});
  EXPECT_NEAR(distance(view), 2.5, 1e-12);
}

TEST(CameraControl, ViewsFromTheSides) {
  const ViewCamera view;
  expect_near(seen_from(view, Side::front).position, {0, 0, 5});
  expect_near(seen_from(view, Side::back).position, {0, 0, -5});
  expect_near(seen_from(view, Side::right).position, {5, 0, 0});
  expect_near(seen_from(view, Side::left).position, {-5, 0, 0});
  const ViewAxes above = axes_of(seen_from(view, Side::top));
  EXPECT_LT(above.ahead.y, -0.99);
  EXPECT_LT(above.above.z, -0.99);
  const ViewAxes below = axes_of(seen_from(view, Side::bottom));
  EXPECT_GT(below.ahead.y, 0.99);
  EXPECT_GT(below.above.z, 0.99);
}

TEST(CameraControl, FramingFillsThePicture) {
  const Bounds box{{9, -1, -1}, {11, 1, 1}};
  for (const double aspect : {0.5, 1.0, 2.0}) {
    const ViewCamera view = framing(ViewCamera{}, box, aspect);
    expect_near(view.pivot, {10, 0, 0});
    // The camera looks along -z: the face of the box at z = 1 fills the picture.
    const double half = std::tan(view.height_angle_deg * std::acos(-1) / 360);
    const double seen = half * std::min(aspect, 1.0) * (view.position.z - 1);
    EXPECT_NEAR(seen, 1.1, 1e-9) << aspect;
  }
  EXPECT_EQ(framing(ViewCamera{}, {}, 1), ViewCamera{});
}

TEST(CameraControl, ThePivotIsInTheScene) {
  const Bounds box{{-1, -1, -1}, {1, 1, 1}};
  Camera camera;
  camera.position = {0, 0, 10};
  camera.look = {0, 0, -3};
  EXPECT_NEAR(pivot_distance(camera, box), 10, 1e-9);
  EXPECT_NEAR(pivot_distance(camera, {}), 3, 1e-6);
  camera.look = {0, 0, 3};
  EXPECT_GT(pivot_distance(camera, box), 0);
}

// For any input the camera keeps its horizon, keeps its distance when it only rotates, and stays
// finite.
RC_GTEST_PROP(CameraControl, StaysACamera, ()) {
  const auto number = [](double most) { return *rc::gen::inRange(-1000, 1000) * most / 1000; };
  ViewCamera view = view_of(some_camera(), 4);
  const int steps = *rc::gen::inRange(1, 30);
  for (int i = 0; i < steps; ++i) {
    const double before = distance(view);
    switch (*rc::gen::inRange(0, 5)) {
      case 0:
        view = orbited(view, number(400), number(400));
        RC_ASSERT(std::abs(distance(view) - before) < 1e-6 * before);
        break;
      case 1:
        view = turned(view, number(400), number(400));
        RC_ASSERT(std::abs(distance(view) - before) < 1e-6 * before);
        break;
      case 2:
        view = panned(view, number(2), number(2));
        break;
      case 3:
        view = zoomed(view, 1 + number(0.5), view.pivot);
        break;
      default:
        view = moved(view, {number(3), number(3), number(3)});
        break;
    }
    const ViewAxes axes = axes_of(view);
    RC_ASSERT(std::abs(glm::dot(axes.right, view.up)) < 1e-9);
    RC_ASSERT(glm::dot(axes.above, view.up) > 0);
    RC_ASSERT(std::isfinite(glm::length(view.position)));
  }
}

}  // namespace

}  // namespace scenefile::viewer
