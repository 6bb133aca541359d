// Reflection and refraction.

#include "trace/build_scene.h"
#include "trace/scalar_rays.h"

#include <gtest/gtest.h>

namespace scenefile::trace_test {
namespace {

constexpr double tolerance = 1e-6;

TEST(Optics, ReflectsAboutTheNormal) {
  const glm::dvec3 d = glm::normalize(glm::dvec3(1, -2, 0.5));
  EXPECT_LT(glm::length(reflect_direction(d, {0, 1, 0}) - d * glm::dvec3(1, -1, 1)), 1e-15);
  EXPECT_EQ(reflect_direction(d, {0, 1, 0}), reflect_direction(d, {0, -1, 0}));
}

TEST(Optics, RefractsBySnellsLaw) {
  for (const double degrees : {0.0, 20.0, 45.0, 80.0}) {
    const double in = glm::radians(degrees);
    glm::dvec3 out;
    ASSERT_TRUE(refract_direction({std::sin(in), -std::cos(in), 0}, {0, 1, 0}, 1 / 1.5, out));
    EXPECT_NEAR(out.x, std::sin(in) / 1.5, 1e-12);
    EXPECT_LT(out.y, 0);
    EXPECT_NEAR(glm::length(out), 1, 1e-12);
  }
}

TEST(Optics, ReflectsTotallyBeyondTheCriticalAngle) {
  const double critical = std::asin(1 / 1.5);
  glm::dvec3 out;
  const auto at = [](double a) { return glm::dvec3(std::sin(a), -std::cos(a), 0); };
  EXPECT_TRUE(refract_direction(at(critical - 1e-6), {0, 1, 0}, 1.5, out));
  EXPECT_FALSE(refract_direction(at(critical + 1e-6), {0, 1, 0}, 1.5, out));
}

TEST(Optics, ReflectsByFresnelsEquations) {
  EXPECT_NEAR(fresnel_reflectance(1, 1 / 1.5), 0.04, 1e-15);
  EXPECT_NEAR(fresnel_reflectance(1, 1.5), 0.04, 1e-15);
  EXPECT_NEAR(fresnel_reflectance(0, 1 / 1.5), 1, 1e-15);
  EXPECT_NEAR(fresnel_reflectance(0.3, 1), 0, 1e-15);
  // At Brewster's angle only s-polarized light is reflected.
  const double brewster = std::atan(1.5);
  const double across = std::cos(2 * brewster);
  EXPECT_NEAR(fresnel_reflectance(std::cos(brewster), 1 / 1.5), across * across / 2, 1e-15);
  const double critical = std::asin(1 / 1.5);
  EXPECT_LT(fresnel_reflectance(std::cos(critical - 1e-4), 1.5), 1);
  EXPECT_EQ(fresnel_reflectance(std::cos(critical + 1e-4), 1.5), 1);
}

TEST(Optics, ReflectsEquallyFromBothSides) {
  for (const double degrees : {5.0, 30.0, 60.0, 85.0}) {
    const double in = glm::radians(degrees);
    const double out = std::asin(std::sin(in) / 1.33);
    EXPECT_NEAR(fresnel_reflectance(std::cos(in), 1 / 1.33),
                fresnel_reflectance(std::cos(out), 1.33), 1e-14);
  }
}

// Clear glass between walls of brightness `behind` (behind the glass) and `before` (behind the
// camera).
SceneBuilder glass_between(Shape shape, float before, float behind) {
  SceneBuilder b;
  RenderMaterial glass;
  glass.diffuse = glm::vec3(0);
  glass.transparent = glm::vec3(1);
  glass.ior = 1.5f;
  b.add(shape, translate({0, 0, -3}), b.material(glass));
  const glm::vec3 wall(40, 40, 0.1f);
  b.add(Shape::cube, translate({0, 0, -9}) * scale(wall), b.glowing(glm::vec3(behind)));
  b.add(Shape::cube, translate({0, 0, 9}) * scale(wall), b.glowing(glm::vec3(before)));
  b.look({0, 0, 0}, {0, 0, -1});
  return b;
}

RenderOptions with_fresnel() {
  RenderOptions options = default_options(Profile::fine);
  options.fresnel = true;
  return options;
}

TEST(Fresnel, ASlabMirrorsAtBothFaces) {
  // The sum of all internal reflections: 2 F / (1 + F).
  const double mirrored = 2 * 0.04 / 1.04;
  EXPECT_NEAR(glass_between(Shape::cube, 1, 0).seen(with_fresnel()).x, mirrored, 1e-3);
  EXPECT_NEAR(glass_between(Shape::cube, 0, 1).seen(with_fresnel()).x, 1 - mirrored, 1e-3);
  EXPECT_NEAR(glass_between(Shape::cube, 1, 0).seen(Profile::fine).x, 0, 1e-12);
}

TEST(Fresnel, NoLightIsLostOrGainedInAFurnace) {
  for (const Shape shape : {Shape::cube, Shape::cone, Shape::cylinder, Shape::sphere}) {
    SceneBuilder b = glass_between(shape, 0.5, 0.5);
    b.add(Shape::sphere, scale(glm::vec3(60)), b.glowing(glm::vec3(0.5)));
    for (const double x : {-0.6, -0.3, 0.1, 0.45}) {
      b.look({0, 0.4, 0}, {x, 0.2, -3});
      EXPECT_NEAR(b.seen(with_fresnel()).x, 0.5, 0.01) << int(shape) << ' ' << x;
    }
  }
}

TEST(Fresnel, TheCourseProfileHasNone) {
  RenderOptions options = default_options(Profile::course);
  options.fresnel = true;
  EXPECT_EQ(glass_between(Shape::cube, 1, 0.5).seen(options),
            glass_between(Shape::cube, 1, 0.5).seen(Profile::course));
}

RenderMaterial mirror(float reflective, float ambient) {
  RenderMaterial m;
  m.diffuse = glm::vec3(0);
  m.reflective = glm::vec3(reflective);
  m.ambient = glm::vec3(ambient);
  return m;
}

// A camera between two facing mirrors.
SceneBuilder mirror_corridor(float reflective, float ambient) {
  SceneBuilder b;
  const std::uint32_t m = b.material(mirror(reflective, ambient));
  b.add(Shape::cube, translate({0, 0, -3}), m);
  b.add(Shape::cube, translate({0, 0, 3}), m);
  b.look({0, 0, 0}, {0, 0, -1});
  return b;
}

double geometric_sum(double ratio, int terms) {
  return (1 - std::pow(ratio, terms)) / (1 - ratio);
}

TEST(Mirror, CourseFollowsFourBounces) {
  EXPECT_NEAR(mirror_corridor(0.5, 0.125).seen().x, 0.125 * geometric_sum(0.5, 5), tolerance);
}

TEST(Mirror, FineFollowsSixteenOrUntilNothingShows) {
  const SceneBuilder b = mirror_corridor(0.75, 0.125);
  EXPECT_NEAR(b.seen(Profile::fine).x, 0.125 * geometric_sum(0.75, 17), tolerance);
  // 0.25^5 is the last weight that is at least 1/1024.
  EXPECT_NEAR(mirror_corridor(0.25, 0.5).seen(Profile::fine).x, 0.5 * geometric_sum(0.25, 6),
              tolerance);
}

TEST(Mirror, DepthIsAnOption) {
  RenderOptions options = default_options(Profile::course);
  for (const int depth : {0, 1, 7, 64}) {
    options.max_depth = depth;
    EXPECT_NEAR(mirror_corridor(0.5, 0.125).seen(options).x, 0.125 * geometric_sum(0.5, depth + 1),
                tolerance);
  }
}

TEST(Mirror, TheSpecularCoefficientScalesIt) {
  SceneBuilder b = mirror_corridor(1, 0.25);
  b.scene.global.specular = 0.5f;
  EXPECT_NEAR(b.seen().x, 0.25 * geometric_sum(0.5, 5), tolerance);
}

TEST(Mirror, CourseClampsEachRayAndFineOnlyThePicture) {
  SceneBuilder b;
  b.add(Shape::cube, translate({0, 0, -3}), b.material(mirror(0.25, 0)));
  b.add(Shape::cube, translate({0, 0, 3}), b.glowing(glm::vec3(3)));
  b.look({0, 0, 0}, {0, 0, -1});
  EXPECT_NEAR(b.seen(Profile::course).x, 0.25, tolerance);
  EXPECT_NEAR(b.seen(Profile::fine).x, 0.75, tolerance);
}

TEST(Mirror, ShowsTheMirrorDirection) {
  // A mirror at 45 degrees reflects -z to +x.
  SceneBuilder b;
  b.add(Shape::cube, Affine{rotate(45, {0, 1, 0}).linear, glm::vec3(0, 0, -3)},
        b.material(mirror(1, 0)));
  const double face = -3 + std::sqrt(0.5);
  b.add(Shape::sphere, translate({-2, 0, float(face)}), b.glowing({1, 0, 0}));
  b.add(Shape::sphere, translate({2, 0, float(face)}), b.glowing({0, 1, 0}));
  b.look({1e-3, 0, 0}, {1e-3, 0, -1});
  EXPECT_NEAR(b.seen().y, 1, tolerance);
  EXPECT_NEAR(b.seen().x, 0, tolerance);
}

TEST(Mirror, CanBeSwitchedOff) {
  RenderOptions options = default_options(Profile::fine);
  options.features.reflect = false;
  EXPECT_NEAR(mirror_corridor(0.5, 0.125).seen(options).x, 0.125, tolerance);
}

RenderMaterial glass(float ior) {
  RenderMaterial m;
  m.diffuse = glm::vec3(0);
  m.transparent = glm::vec3(0.5);
  m.ior = ior;
  return m;
}

// A slab of thickness 1, hit at 45 degrees; behind it a wall perpendicular to the ray's original
// direction, red on one side and green on the other of the point where the ray should arrive.
glm::dvec3 behind_slab(double wall_edge, Profile profile) {
  SceneBuilder b;
  b.add(Shape::cube, scale({20, 1, 20}), b.material(glass(1.5)));
  const auto half = [&](double x, const glm::vec3& color) {
    b.add(Shape::cube, Affine{glm::mat3(10), glm::vec3(float(x), -10.5, 0)}, b.glowing(color));
  };
  half(wall_edge - 5, {1, 0, 0});
  half(wall_edge + 5, {0, 1, 0});
  b.look({-1, 1.5, 0}, {0, 0.5, 0});
  return b.seen(profile);
}

TEST(Glass, ASlabShiftsTheRaySideways) {
  // Enters at (0, 0.5), is displaced by tan(asin(sin 45 / 1.5)), and continues at 45 degrees for 5
  // units.
  const double inside = std::tan(std::asin(std::sqrt(0.5) / 1.5));
  for (const Profile profile : {Profile::course, Profile::fine}) {
    const glm::dvec3 right = behind_slab(inside + 5 - 1e-4, profile);
    const glm::dvec3 left = behind_slab(inside + 5 + 1e-4, profile);
    EXPECT_NEAR(right.y, 0.5, tolerance);  // one factor for the entire passage
    EXPECT_NEAR(right.x, 0, tolerance);
    EXPECT_NEAR(left.x, 0.5, tolerance);
    EXPECT_NEAR(left.y, 0, tolerance);
  }
}

TEST(Glass, ReflectsTotallyInside) {
  // Enters a block from above at 45 degrees. Inside, the ray is 28.1 degrees off the vertical and
  // hits the sides at 61.9 degrees, beyond the critical angle of 41.8; both reflect it totally, and
  // it leaves at the bottom.
  SceneBuilder b;
  b.add(Shape::cube, scale({1, 4, 1}), b.material(glass(1.5)));
  b.add(Shape::cube, Affine{glm::mat3(20), glm::vec3(-10, -20, 0)}, b.glowing({1, 0, 0}));
  b.add(Shape::cube, Affine{glm::mat3(20), glm::vec3(10, -20, 0)}, b.glowing({0, 1, 0}));
  b.look({0, 2.25, 0}, {0.25, 2, 0});
  for (const Profile profile : {Profile::course, Profile::fine}) {
    const glm::dvec3 c = b.seen(profile);
    // The ray enters at x = 0.25, hits x = 0.5 after falling 0.47, and x = -0.5 after 1.87 more: at
    // the bottom it travels to the right.
    EXPECT_NEAR(c.x, 0, tolerance);
    EXPECT_NEAR(c.y, 0.5, tolerance);
  }
}

TEST(Glass, FromInsideLightLeavesOrIsMirrored) {
  SceneBuilder b;
  b.add(Shape::cube, scale({4, 4, 4}), b.material(glass(1.5)));
  b.add(Shape::sphere, Affine{glm::mat3(60), glm::vec3(0, 40, 0)}, b.glowing({1, 0, 0}));
  b.scene.materials[0].ambient = {0, 0, 0};
  b.look({0, 0, 0}, {0, 1, 1e-3});
  EXPECT_NEAR(b.seen().x, 0.5, tolerance);
  const double beyond = glm::radians(43.0);
  b.look({0, 0, 0}, {std::sin(beyond), std::cos(beyond), 0});
  EXPECT_NEAR(b.seen().x, 0, tolerance);
}

TEST(Glass, LocalLightIsNotScaledDown) {
  SceneBuilder b;
  RenderMaterial m = glass(1);
  m.ambient = glm::vec3(0.25);
  b.add(Shape::sphere, translate({0, 0, -3}), b.material(m));
  b.add(Shape::cube, translate({0, 0, -6}), b.glowing(glm::vec3(0.5)));
  b.look({0, 0, 0}, {0, 0, -1});
  EXPECT_NEAR(b.seen().x, 0.25 + 0.5 * 0.5, tolerance);
}

TEST(Glass, TheDefaultCoefficientDependsOnTheProfile) {
  SceneBuilder b;
  RenderMaterial m = glass(1);
  m.transparent = glm::vec3(1);
  b.add(Shape::sphere, translate({0, 0, -3}), b.material(m));
  b.add(Shape::cube, translate({0, 0, -6}), b.glowing(glm::vec3(1)));
  b.look({0, 0, 0}, {0, 0, -1});
  b.scene.global.transparent.reset();
  EXPECT_EQ(b.seen(Profile::course).x, 0);
  EXPECT_NEAR(b.seen(Profile::fine).x, 0.5, tolerance);
}

TEST(Glass, ObjectsInsideAreVisible) {
  SceneBuilder b;
  b.add(Shape::sphere, Affine{glm::mat3(2), glm::vec3(0, 0, -3)}, b.material(glass(1.5)));
  b.add(Shape::cube, Affine{glm::mat3(0.25), glm::vec3(0, 0, -3)}, b.glowing(glm::vec3(1)));
  b.look({0, 0, 0}, {0, 0, -1});
  EXPECT_NEAR(b.seen(Profile::course).x, 0.5, tolerance);
  EXPECT_NEAR(b.seen(Profile::fine).x, 0.5, tolerance);
}

TEST(Glass, NestedGlassIsLeftInReverseOrder) {
  SceneBuilder b;
  b.add(Shape::sphere, Affine{glm::mat3(2), glm::vec3(0, 0, -3)}, b.material(glass(1)));
  b.add(Shape::sphere, Affine{glm::mat3(1), glm::vec3(0, 0, -3)}, b.material(glass(1)));
  b.scene.materials[0].ambient = glm::vec3(0.125);
  b.scene.materials[1].ambient = glm::vec3(0.125);
  b.add(Shape::cube, translate({0, 0, -6}), b.glowing(glm::vec3(1)));
  b.look({0, 0, 0}, {0, 0, -1});
  // Surfaces add no ambient light when the ray leaves them.
  EXPECT_NEAR(b.seen(Profile::fine).x, 0.125 + 0.5 * (0.125 + 0.5), tolerance);
}

TEST(Bounces, MaterialsThatGainLightEnd) {
  // Lossless mirrors and glass, 64 deep: 2^64 rays without a bound.
  SceneBuilder b;
  RenderMaterial m = mirror(1, 0.01f);
  m.transparent = glm::vec3(1);
  const std::uint32_t material = b.material(m);
  for (int i = 0; i < 8; ++i) {
    b.add(Shape::sphere, translate({0, 0, float(-2 - 2 * i)}), material);
  }
  b.look({0, 0, 0}, {0.01, 0, -1});
  RenderOptions options = default_options(Profile::fine);
  options.max_depth = 64;
  EXPECT_GT(b.seen(options).x, 0.01);
}

}  // namespace
}  // namespace scenefile::trace_test
