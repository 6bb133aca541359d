// Laws of optics for random scenes, measured in pictures.

#include "trace/build_scene.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

namespace scenefile::trace_test {
namespace {

using std::numbers::pi;

// In [0, 1].
double random_share() {
  return *rc::gen::inRange(0, 100001) / 100000.0;
}

glm::dvec3 random_direction() {
  const double z = 2 * random_share() - 1;
  const double angle = 2 * pi * random_share();
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  return {r * std::cos(angle), r * std::sin(angle), z};
}

RenderMaterial glass(double ior) {
  RenderMaterial m;
  m.diffuse = glm::vec3(0);
  m.transparent = glm::vec3(1);
  m.ior = static_cast<float>(ior);
  return m;
}

// Surrounds the scene with constant radiance.
void surround(SceneBuilder& b, float radiance) {
  b.add(Shape::sphere, scale(glm::vec3(100)), b.glowing(glm::vec3(radiance)));
}

RC_GTEST_PROP(Furnace, AMirrorInConstantLightShowsItsShareOfIt, ()) {
  SceneBuilder b;
  const auto shape = *rc::gen::element(Shape::sphere, Shape::cylinder, Shape::cone, Shape::cube);
  const float share = static_cast<float>(0.1 + 0.9 * random_share());
  RenderMaterial m;
  m.diffuse = glm::vec3(0);
  m.reflective = glm::vec3(share);
  b.add(shape, rotate(static_cast<float>(360 * random_share()), {1, 2, 3}), b.material(m));
  surround(b, 0.75f);
  b.look(3.0 * random_direction(), 0.2 * random_direction(), 1);
  const Profile profile = *rc::gen::element(Profile::course, Profile::fine);
  RC_ASSERT(std::abs(b.seen(profile).x - 0.75 * share) < 1e-6);
}

// Every wall emits e and reflects the fraction r: e + r e + r^2 e + ... = e / (1 - r).
RC_GTEST_PROP(Furnace, ARoomOfMirrorsIsAGeometricSeries, ()) {
  SceneBuilder b;
  const double r = 0.05 + 0.6 * random_share();
  const double e = 0.25;
  RenderMaterial m;
  m.ambient = glm::vec3(static_cast<float>(e));
  m.diffuse = glm::vec3(0);
  m.reflective = glm::vec3(static_cast<float>(r));
  b.add(*rc::gen::element(Shape::cube, Shape::sphere), scale(glm::vec3(4)), b.material(m));
  const glm::dvec3 eye = 0.5 * random_direction();
  b.look(eye, eye + random_direction());
  // Reflections that add less than 1/1024 are skipped; the largest r needs 16 of them for that.
  const double left_out = (1.0 / 1024) * e / (1 - r);
  const double whole = e / (1 - r);
  const double seen = b.seen(Profile::fine).x;
  RC_ASSERT(seen <= whole + 1e-6);
  RC_ASSERT(seen >= whole - left_out * 1.01 - 1e-6);
}

// In constant light, a clear body without absorption is invisible: refracted light, including total
// internal reflection, is as bright as the background.
RC_GTEST_PROP(Furnace, ClearGlassInConstantLightIsInvisible, ()) {
  SceneBuilder b;
  const double ior = 1 + random_share();
  b.add(Shape::sphere, scale({1, 2, 0.5f}), b.material(glass(ior)));
  surround(b, 0.75f);
  b.look(3.0 * random_direction(), 0.2 * random_direction(), 1);
  RC_ASSERT(std::abs(b.seen(Profile::fine).x - 0.75) < 1e-6);
}

// A ray into a block at `angle`, then to a plate at a depth below the surface that glows on one
// side.
double plate_in_glass(double ior, double angle, double edge, double depth, Profile profile) {
  SceneBuilder b;
  b.add(Shape::cube, Affine{glm::mat3(40), glm::vec3(0, -20, 0)}, b.material(glass(ior)));
  const float x = static_cast<float>(edge);
  b.add(Shape::cube, translate({x - 5, static_cast<float>(-depth) - 0.5f, 0}) * scale({10, 1, 10}),
        b.glowing({1, 0, 0}));
  b.look({-std::sin(angle), std::cos(angle), 0}, {0, 0, 0}, 1);
  return b.seen(profile).x;
}

RC_GTEST_PROP(Snell, TheAngleInsideIsThatOfTheSines, ()) {
  const double ior = 1.01 + 1.5 * random_share();
  const double angle = 1.4 * random_share();
  const double depth = 1 + 3 * random_share();
  const double arrives = depth * std::tan(std::asin(std::sin(angle) / double(float(ior))));
  for (const Profile profile : {Profile::course, Profile::fine}) {
    RC_ASSERT(plate_in_glass(ior, angle, arrives + 1e-4, depth, profile) > 0.99);
    RC_ASSERT(plate_in_glass(ior, angle, arrives - 1e-4, depth, profile) < 0.01);
  }
}

RC_GTEST_PROP(Snell, BeyondTheCriticalAngleNothingLeaves, ()) {
  const double ior = 1.1 + 1.4 * random_share();
  const double critical = std::asin(1 / double(float(ior)));
  SceneBuilder b;
  b.add(Shape::cube, scale({1e4f, 4, 1e4f}), b.material(glass(ior)));
  surround(b, 0.75f);
  b.scene.groups[0].primitives.back().group_from_object = scale(glm::vec3(1e6f));
  const auto seen_at = [&](double angle) {
    b.look({0, 0, 0}, {std::sin(angle), std::cos(angle), 0}, 1);
    RenderOptions options = default_options(Profile::fine);
    options.max_depth = 0;  // without reflected rays
    return b.seen(options).x;
  };
  RC_ASSERT(seen_at(critical + 1e-4) < 1e-6);
}

// A lens images a small object as a disk. At distance d, focused at f, its radius there is aperture
// * |d - f| / f: Hecht, "Optics", for thin lenses on the object side.
TEST(Lens, CircleOfConfusionAndItsLight) {
  for (const double distance : {2.0, 3.0, 4.5, 9.0}) {
    const double focus = 3;
    const double aperture = 0.05;
    const double radius = aperture * std::abs(distance - focus) / focus;
    SceneBuilder b;
    const float size = static_cast<float>(0.6 * radius + 0.004);
    b.add(Shape::sphere, translate({0, 0, static_cast<float>(-distance)}) * scale(glm::vec3(size)),
          b.glowing(glm::vec3(1)));
    b.scene.camera.aperture = aperture;
    b.scene.camera.focal_length = focus;
    RenderOptions options = default_options(Profile::fine);
    options.samples = 1024;
    const double field = 3 * (radius + size);  // width of the picture at that distance
    b.look({0, 0, 0}, {0, 0, -1}, glm::degrees(2 * std::atan(field / 2 / distance)));
    const int side = 33;
    const Image image = b.picture(side, side, options);
    double light = 0, farthest = 0;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const double from_middle = std::hypot(x - side / 2, y - side / 2) * field / side;
        const bool lit = image.pixel(x, y)[0] > 0;
        farthest = lit ? std::max(farthest, from_middle) : farthest;
        light += image.pixel(x, y)[0];
      }
    }
    EXPECT_NEAR(farthest, radius + size / 2, 1.5 * field / side) << distance;
    // Blur spreads the light but keeps its sum.
    const double area = light * (field / side) * (field / side);
    EXPECT_NEAR(area / (pi * size * size / 4), 1, 0.08) << distance;
  }
}

// Three waves along x and two along y, as 8-bit heights.
constexpr int map_side = 64;

std::vector<std::uint8_t> wave_map() {
  std::vector<std::uint8_t> heights;
  for (int row = 0; row < map_side; ++row) {
    for (int column = 0; column < map_side; ++column) {
      const double u = (column + 0.5) / map_side;
      const double v = 1 - (row + 0.5) / map_side;
      const double h = 0.5 + 0.25 * std::sin(6 * pi * u) + 0.25 * std::cos(4 * pi * v);
      heights.push_back(static_cast<std::uint8_t>(std::lround(255 * h)));
    }
  }
  return heights;
}

// The normal of the surface z = h(x, y) / 16.
glm::dvec3 wave_normal(double x, double y) {
  const double slope_x = 0.25 * 6 * pi * std::cos(6 * pi * (x + 0.5)) / 16;
  const double slope_y = -0.25 * 4 * pi * std::sin(4 * pi * (y + 0.5)) / 16;
  return glm::normalize(glm::dvec3(-slope_x, -slope_y, 1));
}

TEST(BumpMap, OfAPlaneHasTheAnalyticNormals) {
  SceneBuilder b;
  RenderMaterial m;
  m.bump_map.file = b.texture(map_side, map_side, wave_map());
  b.add(Shape::cube, Affine(), b.material(m));
  // Diffuse light from three perpendicular directions gives the components of the normal.
  const glm::vec3 from[3] = {glm::normalize(glm::vec3(1, 0, 1)),
                             glm::normalize(glm::vec3(-1, 1, 1)),
                             glm::normalize(glm::vec3(-1, -2, 1))};
  for (int i = 0; i < 3; ++i) {
    glm::vec3 color(0);
    color[i] = 1;
    b.light(LightType::directional, -from[i], color);
  }
  RenderOptions options = default_options(Profile::fine);
  options.features.shadows = false;
  double worst = 0;
  for (double x = -0.4; x <= 0.4; x += 0.0501) {
    for (double y = -0.4; y <= 0.4; y += 0.0501) {
      b.look({x, y, 2}, {x, y, 0}, 0.1);
      const glm::dvec3 seen = b.seen(options);
      for (int i = 0; i < 3; ++i) {
        const double expected = std::max(0.0, glm::dot(wave_normal(x, y), glm::dvec3(from[i])));
        worst = std::max(worst, std::abs(seen[i] - expected));
      }
    }
  }
  // Rounding both ends of two texels to 8 bits changes the slope by 0.008; interpolation causes the
  // rest.
  EXPECT_LT(worst, 0.02);
}

}  // namespace
}  // namespace scenefile::trace_test
