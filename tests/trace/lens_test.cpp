#include "trace/build_scene.h"

#include <gtest/gtest.h>

#include <numeric>

namespace scenefile::trace_test {
namespace {

// A wide wall with its edge at x = 0, at distance 6, seen through a lens focused at 3.
SceneBuilder edge_scene(double aperture, double focal_length) {
  SceneBuilder b;
  b.add(Shape::cube, translate({10, 0, -6}) * scale({20, 20, 1e-6f}), b.glowing(glm::vec3(1)));
  b.scene.camera.aperture = aperture;
  b.scene.camera.focal_length = focal_length;
  return b;
}

// The share of the wall in a pixel that looks at x on the wall's plane.
double share(SceneBuilder b, double x, const RenderOptions& options) {
  b.look({0, 0, 0}, {x, 0, -6}, 0.001);
  // The focal plane stays perpendicular to the view, which rotates slightly: keep x small.
  return b.picture(1, 1, options).pixel(0, 0)[0];
}

TEST(Lens, CircleOfConfusionGrowsWithTheDistanceFromFocus) {
  // Radius of the circle of confusion at distance 6: aperture * (6 - 3) / 3.
  const SceneBuilder b = edge_scene(0.01, 3);
  RenderOptions options = default_options(Profile::fine);
  options.samples = 256;
  EXPECT_EQ(share(b, -0.0101, options), 0);
  EXPECT_NEAR(share(b, 0, options), 0.5, 0.02);
  EXPECT_NEAR(share(b, 0.0101, options), 1, 1e-6);
  // The share of a disk beyond a line at half the radius from its center.
  const double half = 0.5 + (0.5 * std::sqrt(0.75) + std::asin(0.5)) / 3.14159265358979;
  EXPECT_NEAR(share(b, 0.005, options), half, 0.02);
}

TEST(Lens, ObjectsInFocusAreSharp) {
  const SceneBuilder b = edge_scene(0.01, 6);
  for (const Profile profile : {Profile::course, Profile::fine}) {
    EXPECT_EQ(share(b, -1e-4, default_options(profile)), 0);
    EXPECT_NEAR(share(b, 1e-4, default_options(profile)), 1, 1e-6);
  }
}

TEST(Lens, CourseUsesEightPoints) {
  // The lens samples by x: two at -1, one at -1/2, two at 0, one at 1/2, two at 1. Rays from the
  // right arrive on the left.
  const SceneBuilder b = edge_scene(0.01, 3);
  const RenderOptions options = default_options(Profile::course);
  EXPECT_NEAR(share(b, -0.0075, options), 2.0 / 8, 1e-6);
  EXPECT_NEAR(share(b, -0.0025, options), 3.0 / 8, 1e-6);
  EXPECT_NEAR(share(b, 0.0025, options), 5.0 / 8, 1e-6);
  EXPECT_NEAR(share(b, 0.0075, options), 6.0 / 8, 1e-6);
}

TEST(Lens, PinholeWithoutApertureFocusOrFeature) {
  RenderOptions options = default_options(Profile::course);
  EXPECT_EQ(share(edge_scene(0, 3), -0.001, options), 0);
  EXPECT_EQ(share(edge_scene(0.01, 0), -0.001, options), 0);
  EXPECT_GT(share(edge_scene(0.01, 3), -0.001, options), 0);
  options.features.depthoffield = false;
  EXPECT_EQ(share(edge_scene(0.01, 3), -0.001, options), 0);
  options = default_options(Profile::fine);
  options.features.depthoffield = false;
  EXPECT_EQ(share(edge_scene(0.01, 3), -0.001, options), 0);
}

double mean_of(const Image& image) {
  return std::accumulate(image.rgb.begin(), image.rgb.end(), 0.0) / double(image.rgb.size());
}

// Slanted glowing lines, narrower than a pixel: the first samples of a pixel often miss them.
TEST(Lens, NarrowThingsDoNotGetDarker) {
  SceneBuilder b;
  const std::uint32_t glow = b.glowing(glm::vec3(1));
  for (int i = 0; i < 24; ++i) {
    b.add(Shape::cube,
          translate({0.2f * float(i - 12), 0, -6}) * rotate(0.7f * float(i + 1), {0, 0, 1}) *
              scale({0.012f, 8, 0.01f}),
          glow);
  }
  b.scene.camera.aperture = 0.004;
  b.scene.camera.focal_length = 5;
  RenderOptions options = default_options(Profile::fine);
  const Image adaptive = b.picture(120, 90, options);
  options.min_samples = options.samples;
  const Image forced = b.picture(120, 90, options);
  ASSERT_GT(mean_of(forced), 0.05);
  EXPECT_NEAR(mean_of(adaptive), mean_of(forced), 0.1 / 255);
}

}  // namespace
}  // namespace scenefile::trace_test
