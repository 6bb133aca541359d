// Edges of shadows, and light through glass.

#include "trace/build_scene.h"

#include <gtest/gtest.h>

#include <functional>

namespace scenefile::trace_test {
namespace {

// A floor at y = 0, seen from above at (x, 0, 0), ignoring everything above it.
struct Floor {
  SceneBuilder b;

  Floor() { b.add(Shape::cube, Affine{glm::mat3(40), glm::vec3(0, -20, 0)}, b.material({})); }

  double brightness(double x, const RenderOptions& options) {
    b.look({x, 0.5, 0}, {x, 0, 0});
    return b.seen(options).x;
  }
  double brightness(double x, Profile profile = Profile::course) {
    return brightness(x, default_options(profile));
  }
  // The position between two places where the brightness crosses `level`.
  double edge(double low, double high, double level, const RenderOptions& options) {
    const bool rises = brightness(low, options) < level;
    for (int i = 0; i < 40; ++i) {
      const double middle = (low + high) / 2;
      ((brightness(middle, options) < level) == rises ? low : high) = middle;
    }
    return low;
  }
};

TEST(Shadow, TheEdgeIsProjectedFromThePointLight) {
  // A plate up to x = 0.5 at height 1, under a light at height 3: the edge is at 0.5 * 3 / 2.
  for (const Profile profile : {Profile::course, Profile::fine}) {
    Floor floor;
    floor.b.add(Shape::cube,
                Affine{glm::mat3(glm::scale(glm::mat4(1), {1, 1e-4f, 1})), glm::vec3(0, 1, 0)},
                floor.b.material({}));
    floor.b.light(LightType::point, {0, 3, 0}, glm::vec3(0.5));
    EXPECT_NEAR(floor.edge(0.6, 0.9, 0.1, default_options(profile)), 0.75, 1e-4);
  }
}

TEST(Shadow, DirectionalLightsThrowParallelShadows) {
  Floor floor;
  floor.b.add(Shape::sphere, translate({0, 5, 0}), floor.b.material({}));
  floor.b.light(LightType::directional, {0, -1, 0}, glm::vec3(0.5));
  EXPECT_NEAR(floor.edge(0.3, 0.7, 0.1, default_options(Profile::course)), 0.5, 1e-5);
}

TEST(Shadow, ObjectsBehindALightCastNoShadow) {
  Floor floor;
  floor.b.add(Shape::cube, translate({0, 5, 0}), floor.b.material({}));
  floor.b.light(LightType::point, {0, 3, 0}, glm::vec3(0.5));
  EXPECT_GT(floor.brightness(0), 0.4);
  EXPECT_GT(floor.brightness(0, Profile::fine), 0.4);
}

TEST(Shadow, CanBeSwitchedOff) {
  Floor floor;
  floor.b.add(Shape::cube, translate({0, 2, 0}), floor.b.material({}));
  floor.b.light(LightType::point, {0, 3, 0}, glm::vec3(0.5));
  RenderOptions options = default_options(Profile::course);
  EXPECT_EQ(floor.brightness(0, options), 0);
  options.features.shadows = false;
  EXPECT_NEAR(floor.brightness(0, options), 0.5, 1e-6);
}

// `sheets` sheets of colored glass between the light and the floor.
Floor under_glass(int sheets) {
  Floor floor;
  RenderMaterial glass;
  glass.transparent = {0.5, 0.25, 1};
  const std::uint32_t m = floor.b.material(glass);
  for (int i = 0; i < sheets; ++i) {
    floor.b.add(Shape::cube,
                Affine{glm::mat3(glm::scale(glm::mat4(1), {4, 0.1f, 4})), glm::vec3(0, 1 + i, 0)},
                m);
  }
  floor.b.light(LightType::directional, {0, -1, 0}, glm::vec3(0.5));
  floor.b.look({0, 0.5, 0}, {0, 0, 0});
  return floor;
}

TEST(Shadow, FineGlassColorsLightOncePerObject) {
  const glm::dvec3 one = under_glass(1).b.seen(Profile::fine);
  EXPECT_NEAR(one.x, 0.25, 1e-6);
  EXPECT_NEAR(one.y, 0.125, 1e-6);
  EXPECT_NEAR(one.z, 0.5, 1e-6);
  EXPECT_NEAR(under_glass(3).b.seen(Profile::fine).x, 0.5 / 8, 1e-6);
}

TEST(Shadow, CourseGlassBlocksAllLight) {
  EXPECT_EQ(under_glass(1).b.seen(Profile::course), glm::dvec3(0));
}

TEST(Shadow, GlassBlocksWhereRefractionIsOff) {
  RenderOptions options = default_options(Profile::fine);
  options.features.refract = false;
  EXPECT_EQ(under_glass(1).b.seen(options), glm::dvec3(0));
}

// An area light at height 4, one unit wide along x, above a plate with its edge at x = 0 and height
// 1: the penumbra extends from -1/6 to 1/6.
Floor penumbra_scene() {
  Floor floor;
  floor.b.add(Shape::cube,
              Affine{glm::mat3(glm::scale(glm::mat4(1), {20, 1e-4f, 20})), glm::vec3(-10, 1, 0)},
              floor.b.material({}));
  RenderLight& light = floor.b.light(LightType::area, {0, 4, 0}, glm::vec3(0.5));
  light.half_u = {0.5, 0, 0};
  light.half_v = {0, 0, 1e-3f};
  return floor;
}

TEST(Shadow, PenumbraOfAnAreaLightHasTheWidthOfSimilarTriangles) {
  Floor floor = penumbra_scene();
  EXPECT_EQ(floor.brightness(-1.0 / 6 - 1e-3), 0);
  EXPECT_GT(floor.brightness(1.0 / 6 + 1e-3), 0.49);
  // The course's grid has four columns, the outer ones 3/8 from the center.
  RenderOptions options = default_options(Profile::course);
  EXPECT_NEAR(floor.edge(-0.2, 0, 0.01, options), -0.375 / 3, 1e-4);
  EXPECT_NEAR(floor.edge(0, 0.2, 0.45, options), 0.375 / 3, 1e-4);
}

TEST(Shadow, FinePenumbraIsSmooth) {
  Floor floor = penumbra_scene();
  RenderOptions options = default_options(Profile::fine);
  options.samples = 64;
  const auto share = [&](double x) {
    floor.b.look({x, 0.5, 0}, {x, 0, 0}, 0.01);
    const Image image = floor.b.picture(1, 1, options);
    return image.pixel(0, 0)[0] / 0.5;
  };
  EXPECT_EQ(share(-0.17), 0);
  for (const double x : {-0.1, -0.03, 0.0, 0.07, 0.12}) {
    EXPECT_NEAR(share(x), 0.5 + 3 * x, 0.03) << x;
  }
  EXPECT_GT(share(0.17), 0.98);
}

}  // namespace
}  // namespace scenefile::trace_test
