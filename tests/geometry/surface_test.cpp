#include "geometry/solids.h"
#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/geometry/surface-inl.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace scenefile {
namespace {

using glm::dvec2;
using glm::dvec3;
using test::analytic_shapes;
using test::implicit;
using test::name_of;

// u = 0 and u = 1 are the same line on a round side.
double uv_distance(const dvec2& a, const dvec2& b) {
  const double du = std::abs(a.x - b.x);
  return std::hypot(std::min(du, 1 - du), a.y - b.y);
}

TEST(SurfaceAt, UvInvertsTheParametersOfEveryFace) {
  std::mt19937_64 random(1);
  for (const Shape shape : analytic_shapes) {
    for (int i = 0; i < 5000; ++i) {
      const test::RandomPoint p = test::random_point(shape, random);
      const Surface s = surface_at(shape, p.face, p.at.point);
      EXPECT_LT(uv_distance(s.uv, p.at.uv), 1e-12) << name_of(shape) << int(p.face);
      EXPECT_GE(s.uv.x, 0);
      EXPECT_LE(s.uv.x, 1);
      EXPECT_GE(s.uv.y, 0);
      EXPECT_LE(s.uv.y, 1);
    }
  }
}

TEST(SurfaceAt, NormalIsTheGradientOfTheSolid) {
  std::mt19937_64 random(2);
  for (const Shape shape : analytic_shapes) {
    for (int i = 0; i < 5000; ++i) {
      const Face face = test::faces_of(shape)[random() % test::faces_of(shape).size()];
      const double a = test::uniform(random, 0.01, 0.99);
      const dvec3 p = test::point_on(shape, face, a, test::uniform(random, 0.01, 0.97)).point;
      const double h = 1e-6;
      dvec3 gradient;
      for (int axis = 0; axis < 3; ++axis) {
        dvec3 step(0);
        step[axis] = h;
        gradient[axis] = implicit(shape, p + step) - implicit(shape, p - step);
      }
      const Surface s = surface_at(shape, face, p);
      EXPECT_NEAR(glm::length(s.normal), 1, 1e-15);
      EXPECT_LT(glm::length(s.normal - glm::normalize(gradient)), 1e-6) << name_of(shape);
    }
  }
}

TEST(SurfaceAt, TangentsAreTheDerivativesByUv) {
  std::mt19937_64 random(3);
  for (const Shape shape : analytic_shapes) {
    for (const Face face : test::faces_of(shape)) {
      if (shape != Shape::cube && face != Face::side) {
        continue;  // caps: their uv is not polar, see below
      }
      for (int i = 0; i < 2000; ++i) {
        const double u = test::uniform(random, 0.01, 0.99);
        const double v = test::uniform(random, 0.01, 0.99);
        const double h = 1e-6;
        const auto point = [&](double du, double dv) {
          return test::point_on(shape, face, u + du, v + dv).point;
        };
        const Surface s = surface_at(shape, face, point(0, 0));
        const dvec3 by_u = (point(h, 0) - point(-h, 0)) / (2 * h);
        const dvec3 by_v = (point(0, h) - point(0, -h)) / (2 * h);
        EXPECT_LT(glm::length(s.tangent_u - by_u), 1e-8) << name_of(shape) << int(face);
        EXPECT_LT(glm::length(s.tangent_v - by_v), 1e-8) << name_of(shape) << int(face);
        EXPECT_GT(glm::dot(glm::cross(s.tangent_u, s.tangent_v), s.normal), 0);
      }
    }
  }
}

TEST(SurfaceAt, CapsAreFlatMaps) {
  const Surface top = surface_at(Shape::cylinder, Face::top, {0.2, 0.5, 0.3});
  EXPECT_EQ(top.normal, dvec3(0, 1, 0));
  EXPECT_LT(glm::length(top.uv - dvec2(0.7, 0.2)), 1e-15);
  EXPECT_EQ(top.tangent_u, dvec3(1, 0, 0));
  EXPECT_EQ(top.tangent_v, dvec3(0, 0, -1));
  for (const Shape shape : {Shape::cylinder, Shape::cone}) {
    const Surface bottom = surface_at(shape, Face::bottom, {0.2, -0.5, 0.3});
    EXPECT_EQ(bottom.normal, dvec3(0, -1, 0));
    EXPECT_LT(glm::length(bottom.uv - dvec2(0.7, 0.8)), 1e-15);
    EXPECT_EQ(bottom.tangent_u, dvec3(1, 0, 0));
    EXPECT_EQ(bottom.tangent_v, dvec3(0, 0, 1));
  }
}

// Points computed by hand from the course's formulas: u increases clockwise from +x, seen from
// above.
TEST(SurfaceAt, QuartersOfTheRoundSide) {
  for (const Shape shape : {Shape::cone, Shape::cylinder, Shape::sphere}) {
    const double r = shape == Shape::cone ? 0.25 : 0.5;
    EXPECT_DOUBLE_EQ(surface_at(shape, Face::side, {r, 0, 0}).uv.x, 1);
    EXPECT_DOUBLE_EQ(surface_at(shape, Face::side, {0, 0, r}).uv.x, 0.75);
    EXPECT_DOUBLE_EQ(surface_at(shape, Face::side, {-r, 0, 0}).uv.x, 0.5);
    EXPECT_DOUBLE_EQ(surface_at(shape, Face::side, {0, 0, -r}).uv.x, 0.25);
    EXPECT_DOUBLE_EQ(surface_at(shape, Face::side, {0, 0, -r}).uv.y, 0.5);
  }
}

TEST(SurfaceAt, PolesAndApexAreFinite) {
  for (const double y : {0.5, -0.5}) {
    const Surface s = surface_at(Shape::sphere, Face::side, {0, y, 0});
    EXPECT_EQ(s.normal, dvec3(s.normal.x, 2 * y, s.normal.z));
    EXPECT_LT(std::abs(s.normal.x), 1e-15);
    EXPECT_EQ(s.tangent_u, dvec3(0));
    EXPECT_NEAR(glm::length(s.tangent_v), 1.5707963267948966, 1e-12);
    EXPECT_DOUBLE_EQ(s.uv.y, y + 0.5);
  }
  const Surface apex = surface_at(Shape::cone, Face::side, {0, 0.5, 0});
  EXPECT_EQ(apex.normal, dvec3(0, 1, 0));
  EXPECT_EQ(apex.tangent_u, dvec3(0));
  EXPECT_EQ(apex.uv.y, 1);
}

TEST(SurfaceAt, AnglesAgreeWithTheStandardLibrary) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 100000; ++i) {
    const double x = test::uniform(random, -1, 1);
    const double y = test::uniform(random, -1, 1) * std::exp2(test::uniform(random, -40, 40));
    EXPECT_NEAR(one::angle_of(y, x), std::atan2(y, x), 4.5e-16 * std::abs(std::atan2(y, x)));
  }
  for (const double x : {-1.0, 0.0, 1.0}) {
    for (const double y : {-1.0, -0.0, 0.0, 1.0}) {
      EXPECT_EQ(one::angle_of(y, x), std::atan2(y, x)) << y << ' ' << x;
    }
  }
}

RC_GTEST_PROP(SurfaceLaw, PointsOffTheSurfaceAreProjected, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  for (const Shape shape : analytic_shapes) {
    const Face face = test::faces_of(shape)[random() % test::faces_of(shape).size()];
    const double a = test::uniform(random, 0.01, 0.99);
    const dvec3 p = test::point_on(shape, face, a, test::uniform(random, 0.01, 0.97)).point;
    const dvec3 off = p + 1e-7 * test::random_direction(random);
    const Surface exact = surface_at(shape, face, p);
    const Surface near = surface_at(shape, face, off);
    RC_ASSERT(std::abs(glm::length(near.normal) - 1) < 1e-14);
    RC_ASSERT(glm::length(near.normal - exact.normal) < 1e-4);
    RC_ASSERT(uv_distance(near.uv, exact.uv) < 1e-4);
  }
}

}  // namespace
}  // namespace scenefile
