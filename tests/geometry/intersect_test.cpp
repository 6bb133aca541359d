#include "geometry/solids.h"
#include "scenefile/geometry/shapes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace scenefile {
namespace {

using glm::dvec3;
using test::analytic_shapes;
using test::implicit;
using test::name_of;
using test::uniform;

constexpr double infinity = std::numeric_limits<double>::infinity();

dvec3 at(const Ray& ray, double t) {
  return ray.origin + t * ray.direction;
}

struct Crossing {
  bool found = false;
  double t = 0;
};

// Marches in small steps with a membership test and bisects the first change: slow, but independent
// of the quadratics under test.
Crossing march(Shape shape, const Ray& ray, double t_max, int steps) {
  const bool inside = implicit(shape, ray.origin) < 0;
  double low = 0;
  for (int i = 1; i <= steps; ++i) {
    double high = t_max * i / steps;
    if ((implicit(shape, at(ray, high)) < 0) != inside) {
      for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        ((implicit(shape, at(ray, middle)) < 0) == inside ? low : high) = middle;
      }
      return {true, low};
    }
    low = high;
  }
  return {};
}

// Whether the ray passes so close to the surface that marching may miss it.
bool grazes(Shape shape, const Ray& ray, double t_max, int steps) {
  double least = 1;
  for (int i = 0; i <= steps; ++i) {
    least = std::min(least, implicit(shape, at(ray, t_max * i / steps)));
  }
  return std::abs(least) < 0.02;
}

TEST(Intersect, AgreesWithMarching) {
  std::mt19937_64 random(1);
  for (const Shape shape : analytic_shapes) {
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
      const dvec3 origin(uniform(random, -1.5, 1.5), uniform(random, -1.5, 1.5),
                         uniform(random, -1.5, 1.5));
      const dvec3 target(uniform(random, -0.7, 0.7), uniform(random, -0.7, 0.7),
                         uniform(random, -0.7, 0.7));
      const Ray ray{origin, glm::normalize(target - origin)};
      const Crossing expected = march(shape, ray, 4, 800);
      ShapeHit hit;
      const bool found = intersect(shape, ray, 0, 4, hit);
      if (found != expected.found || (found && std::abs(hit.t - expected.t) > 1e-9)) {
        EXPECT_TRUE(grazes(shape, ray, 4, 800))
            << name_of(shape) << " " << i << ": " << found << " " << hit.t << ", marching "
            << expected.found << " " << expected.t;
      }
      hits += found;
    }
    EXPECT_GT(hits, 6000) << name_of(shape);
  }
}

TEST(Intersect, HitsTheAimedPointFromEverywhere) {
  std::mt19937_64 random(2);
  for (const Shape shape : analytic_shapes) {
    for (int i = 0; i < 20000; ++i) {
      const test::RandomPoint aim = test::random_point(shape, random);
      const dvec3 outward = surface_at(shape, aim.face, aim.at.point).normal;
      dvec3 direction = test::random_direction(random);
      if (glm::dot(direction, outward) > -0.05) {
        continue;
      }
      const double distance = std::pow(10.0, uniform(random, -2, 6));
      const double length = std::pow(10.0, uniform(random, -30, 30));
      const Ray ray{aim.at.point - distance * direction, length * direction};
      ShapeHit hit;
      ASSERT_TRUE(intersect(shape, ray, 0, infinity, hit)) << name_of(shape) << " " << i;
      const double error = 1e-14 * (1 + distance);
      EXPECT_NEAR(hit.t * length, distance, 30 * error) << name_of(shape) << " " << i;
      if (test::implicit(shape, aim.at.point + 1e-3 * outward) > 9e-4) {
        EXPECT_EQ(hit.face, aim.face);
      }
    }
  }
}

TEST(Intersect, SeesTheFarSideFromInsideAndBetweenLimits) {
  for (const Shape shape : analytic_shapes) {
    const Ray ray{{0, -2, 0}, {0, 1, 0}};
    ShapeHit hit;
    ASSERT_TRUE(intersect(shape, ray, 0, 10, hit));
    EXPECT_DOUBLE_EQ(hit.t, 1.5);
    EXPECT_FALSE(intersect(shape, ray, 0, 1.5, hit)) << "t_max is not part of the range";
    ASSERT_TRUE(intersect(shape, ray, 1.5, 10, hit)) << "t_min is not part of the range";
    EXPECT_DOUBLE_EQ(hit.t, 2.5);
    EXPECT_FALSE(intersect(shape, ray, 2.5, 10, hit));
    ASSERT_TRUE(intersect(shape, {{0, 0, 0}, {0, -2, 0}}, 0, 10, hit));
    EXPECT_DOUBLE_EQ(hit.t, 0.25);
  }
}

TEST(Intersect, AMissDoesNotChangeTheHit) {
  ShapeHit hit{7, Face::top};
  EXPECT_FALSE(intersect(Shape::sphere, {{0, 2, 0}, {0, 1, 0}}, 0, 10, hit));
  EXPECT_FALSE(intersect(Shape::mesh, {{0, 0, 2}, {0, 0, -1}}, 0, 10, hit));
  EXPECT_EQ(hit.t, 7);
  EXPECT_EQ(hit.face, Face::top);
}

TEST(Intersect, NamesTheFace) {
  const struct {
    Shape shape;
    dvec3 from;
    Face face;
  } cases[] = {
      {Shape::cube, {2, 0.1, 0.1}, Face::pos_x},   {Shape::cube, {-2, 0.1, 0.1}, Face::neg_x},
      {Shape::cube, {0.1, 2, 0.1}, Face::pos_y},   {Shape::cube, {0.1, -2, 0.1}, Face::neg_y},
      {Shape::cube, {0.1, 0.1, 2}, Face::pos_z},   {Shape::cube, {0.1, 0.1, -2}, Face::neg_z},
      {Shape::cylinder, {0.1, 2, 0.1}, Face::top}, {Shape::cylinder, {0.1, -2, 0.1}, Face::bottom},
      {Shape::cylinder, {0, 0.1, 2}, Face::side},  {Shape::cone, {0.1, 2, 0}, Face::side},
      {Shape::cone, {0.1, -2, 0}, Face::bottom},   {Shape::cone, {2, 0.1, 0}, Face::side}};
  for (const auto& c : cases) {
    const dvec3 away = glm::abs(c.from);
    dvec3 direction(0);
    const int axis = away.x > 1 ? 0 : away.y > 1 ? 1 : 2;
    direction[axis] = -c.from[axis];
    ShapeHit hit;
    ASSERT_TRUE(intersect(c.shape, {c.from, direction}, 0, 10, hit));
    EXPECT_EQ(hit.face, c.face) << name_of(c.shape) << " from axis " << axis;
  }
}

// Coplanar faces of adjacent cubes must give exactly equal distances.
TEST(Intersect, DistanceToACubeIsOneDivision) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 1000; ++i) {
    const dvec3 origin(uniform(random, -9, 9), uniform(random, -9, 9), uniform(random, 1, 9));
    const dvec3 target(uniform(random, -0.4, 0.4), uniform(random, -0.4, 0.4), 0.5);
    const Ray ray{origin, target - origin};
    ShapeHit hit;
    ASSERT_TRUE(intersect(Shape::cube, ray, 0, 10, hit));
    if (hit.face == Face::pos_z) {
      EXPECT_EQ(hit.t, (0.5 - origin.z) / ray.direction.z);
    }
  }
}

TEST(Intersect, TheMirroredHalfOfTheConeIsNotHit) {
  ShapeHit hit;
  // A flat ray, only through the mirrored half; a steep ray, through it and then the cone; and one
  // along the axis.
  EXPECT_FALSE(intersect(Shape::cone, {{-2, 1, 0.1}, {1, 0, 0}}, 0, 100, hit));
  EXPECT_FALSE(intersect(Shape::cone, {{-2, 1, 0}, {1, 0.1, 0}}, 0, 100, hit));
  ASSERT_TRUE(intersect(Shape::cone, {{0.1, 2, 0}, {0, -1, 0}}, 0, 100, hit));
  EXPECT_NEAR(2 - hit.t, 0.5 - 2 * 0.1, 1e-15);
  ASSERT_TRUE(intersect(Shape::cone, {{0, 2, 0}, {0, -1, 0}}, 0, 100, hit));
  EXPECT_DOUBLE_EQ(hit.t, 1.5);
  EXPECT_FALSE(intersect(Shape::cone, {{0, 2, 0}, {0, 1, 0}}, 0, 100, hit));
  EXPECT_FALSE(intersect(Shape::cone, {{0.1, 0.6, 0}, {0, 1, 0}}, 0, 100, hit));
}

// Along a generator, the quadratic becomes linear; nearby directions are ill-conditioned.
TEST(Intersect, RaysAlongAGeneratorOfTheCone) {
  for (const double tilt : {0.0, 1e-17, -1e-17, 1e-12, -1e-12, 1e-8, -1e-8, 1e-4, -1e-4}) {
    for (const double sign : {1.0, -1.0}) {
      const dvec3 direction = sign * dvec3(0.5 + tilt, -1, 0);
      // Through (-0.2, 0, 0), inside; the ray leaves through the base or through the far side.
      const Ray ray{dvec3(-0.2, 0, 0) - 3.0 * direction, direction};
      ShapeHit first, second;
      ASSERT_TRUE(intersect(Shape::cone, ray, 0, 100, first)) << tilt << " " << sign;
      ASSERT_TRUE(intersect(Shape::cone, ray, first.t, 100, second)) << tilt << " " << sign;
      EXPECT_NEAR(implicit(Shape::cone, at(ray, first.t)), 0, 1e-14);
      EXPECT_NEAR(implicit(Shape::cone, at(ray, second.t)), 0, 1e-14);
      EXPECT_GT(second.t - first.t, 0.5);
      EXPECT_LT(implicit(Shape::cone, at(ray, 0.5 * (first.t + second.t))), 0);
      // The mirror of that line is only in the mirrored half, above.
      const Ray above{dvec3(-0.2, 1, 0) - 3.0 * direction, direction};
      const dvec3 low = at(above, 3 + sign * 1.5);
      EXPECT_EQ(intersect(Shape::cone, above, 0, 100, first), implicit(Shape::cone, low) < 0);
    }
  }
}

TEST(Intersect, RaysInThePlaneOfAFaceTouchIt) {
  ShapeHit hit;
  for (const double level : {0.5, -0.5}) {
    EXPECT_TRUE(intersect(Shape::cube, {{level, 0.1, 5}, {0, 0, -1}}, 0, 100, hit));
    EXPECT_TRUE(intersect(Shape::cube, {{5, level, 0.1}, {-1, 0, 0}}, 0, 100, hit));
    EXPECT_TRUE(intersect(Shape::cylinder, {{5, level, 0.1}, {-1, 0, 0}}, 0, 100, hit));
    EXPECT_NEAR(5 - hit.t, std::sqrt(0.25 - 0.01), 1e-14);
  }
  EXPECT_TRUE(intersect(Shape::cylinder, {{0.5, 5, 0}, {0, -1, 0}}, 0, 100, hit));
  EXPECT_DOUBLE_EQ(hit.t, 4.5);
  EXPECT_TRUE(intersect(Shape::cone, {{5, -0.5, 0}, {-1, 0, 0}}, 0, 100, hit));
  EXPECT_DOUBLE_EQ(hit.t, 4.5);
  const double off = std::nextafter(0.5, 1.0);
  EXPECT_FALSE(intersect(Shape::cube, {{off, 0.1, 5}, {0, 0, -1}}, 0, 100, hit));
  EXPECT_FALSE(intersect(Shape::cylinder, {{5, off, 0.1}, {-1, 0, 0}}, 0, 100, hit));
  EXPECT_FALSE(intersect(Shape::cylinder, {{off, 5, 0}, {0, -1, 0}}, 0, 100, hit));
}

// A tangent ray moved inward by 2^-k must hit, moved outward must miss, down to rounding.
TEST(Intersect, DecidesGrazingRays) {
  for (int k = 1; k <= 50; ++k) {
    const double by = std::ldexp(1.0, -k);
    for (const Shape shape : {Shape::sphere, Shape::cylinder}) {
      ShapeHit hit;
      ASSERT_TRUE(intersect(shape, {{0.5 - by, 0, 3}, {0, 0, -1}}, 0, 10, hit)) << k;
      EXPECT_NEAR(3 - hit.t, std::sqrt(by * (1 - by)), 1e-9);
      EXPECT_FALSE(intersect(shape, {{0.5 + by, 0, 3}, {0, 0, -1}}, 0, 10, hit)) << k;
    }
    ShapeHit hit;
    EXPECT_TRUE(intersect(Shape::cone, {{0.25 - by, 0, 3}, {0, 0, -1}}, 0, 10, hit)) << k;
    EXPECT_FALSE(intersect(Shape::cone, {{0.25 + by, 0, 3}, {0, 0, -1}}, 0, 10, hit)) << k;
  }
}

TEST(Intersect, NearTheApexOfTheCone) {
  for (int k = 1; k < 300; ++k) {
    const double small = std::ldexp(1.0, -k) / 3;
    ShapeHit hit;
    ASSERT_TRUE(intersect(Shape::cone, {{small, 2, 0}, {0, -1, 0}}, 0, 10, hit)) << k;
    EXPECT_NEAR(2 - hit.t, 0.5 - 2 * small, 1e-15) << k;
  }
}

// Steep rays through the apex must hit; rounding must not cause a gap.
TEST(Intersect, ThroughTheApexOfTheCone) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 20000; ++i) {
    const double slope = uniform(random, 0, 0.49);
    const double turn = uniform(random, 0, 6.3);
    const dvec3 down(slope * std::cos(turn), -1, slope * std::sin(turn));
    const Ray ray{dvec3(0, 0.5, 0) - uniform(random, 0.1, 9) * down, down};
    ShapeHit hit;
    ASSERT_TRUE(intersect(Shape::cone, ray, 0, infinity, hit)) << i;
    ASSERT_NEAR(at(ray, hit.t).y, 0.5, 1e-6) << i;
  }
}

// From inside, every ray hits: no gap at edges, rims or seams.
TEST(Intersect, NoRayEscapesThroughAnEdge) {
  const dvec3 edges[] = {{0.5, 0.5, 0},  {0.5, 0.5, 0.5}, {0, -0.5, 0.5},   {-0.5, 0.3, -0.5},
                         {0.5, -0.5, 0}, {0, 0.5, 0},     {0.3, -0.5, -0.4}};
  std::mt19937_64 random(3);
  for (const Shape shape : analytic_shapes) {
    for (const dvec3& edge : edges) {
      for (int i = 0; i < 3000; ++i) {
        const dvec3 origin(uniform(random, -0.1, 0.1), uniform(random, -0.4, 0),
                           uniform(random, -0.1, 0.1));
        ASSERT_LT(implicit(shape, origin), 0);
        const Ray ray{origin, (edge - origin) * uniform(random, 0.1, 3)};
        ShapeHit hit;
        ASSERT_TRUE(intersect(shape, ray, 0, infinity, hit)) << name_of(shape) << " " << i;
        ASSERT_NEAR(implicit(shape, at(ray, hit.t)), 0, 1e-14);
      }
    }
  }
}

TEST(Intersect, DirectionsOfAnyLength) {
  for (const Shape shape : analytic_shapes) {
    for (const double length : {1e-307, 1e-300, 1e-150, 1e-60, 1e60, 1e150, 1e300, 1.7e308}) {
      ShapeHit hit;
      ASSERT_TRUE(intersect(shape, {{0, -2.5, 0}, {0, length, 0}}, 0, infinity, hit)) << length;
      EXPECT_NEAR(hit.t * length, 2, 1e-12) << length;
      EXPECT_FALSE(intersect(shape, {{0, -2.5, 0}, {0, length, 0}}, 0, 1.9 / length, hit));
    }
  }
}

TEST(Intersect, NonFiniteRaysHitNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Shape shape : analytic_shapes) {
    for (const double bad : {nan, infinity, -infinity}) {
      for (int axis = 0; axis < 3; ++axis) {
        Ray ray{{0.1, 0.1, 0.1}, {0.3, 0.4, 0.5}};
        ShapeHit hit;
        ray.direction[axis] = bad;
        EXPECT_FALSE(intersect(shape, ray, 0, infinity, hit));
        ray.direction[axis] = 0.3;
        ray.origin[axis] = bad;
        EXPECT_FALSE(intersect(shape, ray, 0, infinity, hit));
      }
    }
    ShapeHit hit;
    EXPECT_FALSE(intersect(shape, {{0, 0, 0}, {0, 0, 0}}, 0, infinity, hit));
    EXPECT_FALSE(intersect(shape, {{1e300, 1e300, 1e300}, {-1, -1, -1.1}}, 0, infinity, hit));
  }
}

TEST(Intersect, FromVeryFar) {
  for (const Shape shape : analytic_shapes) {
    for (const double distance : {1e6, 1e9, 1e12, 1e15}) {
      ShapeHit hit;
      ASSERT_TRUE(intersect(shape, {{0.1, -distance, 0.1}, {0, 1, 0}}, 0, infinity, hit));
      EXPECT_NEAR(hit.t, distance - 0.5, shape == Shape::sphere ? 0.2 : 1e-16 * distance);
      EXPECT_FALSE(intersect(shape, {{0.6, -distance, 0.1}, {0, 1, 0}}, 0, infinity, hit));
    }
  }
}

RC_GTEST_PROP(IntersectLaw, HitPointsLieOnTheSurface, ()) {
  const auto shape = *rc::gen::elementOf(
      std::vector<Shape>(std::begin(analytic_shapes), std::end(analytic_shapes)));
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const double far = std::pow(10.0, uniform(random, -1, 8));
  const dvec3 origin = far * test::random_direction(random);
  const dvec3 target = uniform(random, 0, 0.8) * test::random_direction(random);
  const Ray ray{origin, target - origin};
  ShapeHit hit;
  if (intersect(shape, ray, 0, infinity, hit)) {
    RC_ASSERT(std::abs(implicit(shape, at(ray, hit.t))) <= 1e-15 * (10 + far));
    RC_ASSERT(hit.t > 0);
    ShapeHit second;
    if (intersect(shape, ray, hit.t, infinity, second)) {
      const dvec3 middle = at(ray, 0.5 * (hit.t + second.t));
      RC_ASSERT(implicit(shape, middle) <= 1e-15 * (10 + far));
    }
  } else {
    RC_ASSERT(implicit(shape, target) >= -1e-15 * (10 + far));
  }
}

// The symmetries of each shape (reflections and rotations) preserve t.
RC_GTEST_PROP(IntersectLaw, SymmetryOfTheShapes, ()) {
  const auto shape = *rc::gen::elementOf(
      std::vector<Shape>(std::begin(analytic_shapes), std::end(analytic_shapes)));
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const dvec3 origin = 2.0 * test::random_direction(random);
  const Ray ray{origin, 0.7 * test::random_direction(random) - origin};
  const auto turned = [](const dvec3& v) { return dvec3(-v.z, v.y, v.x); };
  const auto mirrored = [](const dvec3& v) { return dvec3(-v.x, v.y, v.z); };
  ShapeHit hit, other;
  const bool found = intersect(shape, ray, 0, 10, hit);
  const Ray quarter{turned(ray.origin), turned(ray.direction)};
  RC_ASSERT(intersect(shape, quarter, 0, 10, other) == found);
  RC_ASSERT(!found || std::abs(hit.t - other.t) < 1e-9);
  const Ray mirror{mirrored(ray.origin), mirrored(ray.direction)};
  RC_ASSERT(intersect(shape, mirror, 0, 10, other) == found);
  RC_ASSERT(!found || std::abs(hit.t - other.t) < 1e-9);
}

}  // namespace
}  // namespace scenefile
