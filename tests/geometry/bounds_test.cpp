#include "geometry/solids.h"
#include "scenefile/geometry/shapes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace scenefile {
namespace {

using glm::dvec3;
using test::analytic_shapes;
using test::name_of;

DAffine random_map(std::mt19937_64& random) {
  const double scale = std::pow(10.0, test::uniform(random, -3, 3));
  DAffine map;
  for (int column = 0; column < 3; ++column) {
    map.linear[column] = scale * test::random_direction(random);
  }
  map.offset = 10 * scale * test::random_direction(random);
  return map;
}

// The support of a solid in a direction, by definition: the maximum over many surface points.
double sampled_support(Shape shape, const dvec3& direction) {
  double best = -1e300;
  for (const Face face : test::faces_of(shape)) {
    for (int i = 0; i <= 200; ++i) {
      for (int j = 0; j <= 100; ++j) {
        const dvec3 p = test::point_on(shape, face, i / 200.0, j / 100.0).point;
        best = std::max(best, glm::dot(direction, p));
      }
    }
  }
  return best;
}

RC_GTEST_PROP(BoundsLaw, HoldTheWholeShape, ()) {
  std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
  const DAffine map = random_map(random);
  for (const Shape shape : analytic_shapes) {
    const Bounds box = shape_bounds(shape, map);
    const double slack = 1e-13 * glm::length(map.offset);
    for (int i = 0; i < 200; ++i) {
      const dvec3 p = map.point(test::random_point(shape, random).at.point);
      RC_ASSERT(glm::all(glm::greaterThanEqual(p, box.min - slack)));
      RC_ASSERT(glm::all(glm::lessThanEqual(p, box.max + slack)));
    }
  }
}

TEST(Bounds, AreTight) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 6; ++i) {
    const DAffine map = random_map(random);
    const dvec3 rows[] = {glm::transpose(map.linear)[0], glm::transpose(map.linear)[1],
                          glm::transpose(map.linear)[2]};
    for (const Shape shape : analytic_shapes) {
      const Bounds box = shape_bounds(shape, map);
      for (int axis = 0; axis < 3; ++axis) {
        const double size = glm::length(rows[axis]);
        const double high = map.offset[axis] + sampled_support(shape, rows[axis]);
        const double low = map.offset[axis] - sampled_support(shape, -rows[axis]);
        EXPECT_NEAR(box.max[axis], high, 2e-3 * size) << name_of(shape);
        EXPECT_NEAR(box.min[axis], low, 2e-3 * size) << name_of(shape);
      }
    }
  }
}

TEST(Bounds, OfTheUnitShapes) {
  for (const Shape shape : analytic_shapes) {
    const Bounds box = shape_bounds(shape, {});
    EXPECT_EQ(box.min, dvec3(-0.5)) << name_of(shape);
    EXPECT_EQ(box.max, dvec3(0.5)) << name_of(shape);
  }
  EXPECT_TRUE(shape_bounds(Shape::mesh, {}).empty());
}

// Rotated by 45 degrees about z, the cylinder's extent is half of (1 + 1) / sqrt 2 in x and y.
TEST(Bounds, OfATurnedCylinderAndCone) {
  const double h = std::sqrt(0.5);
  const DAffine turn(glm::dmat3(h, h, 0, -h, h, 0, 0, 0, 1), dvec3(1, 2, 3));
  const Bounds cylinder = shape_bounds(Shape::cylinder, turn);
  EXPECT_LT(glm::length(cylinder.max - (dvec3(1, 2, 3) + dvec3(h, h, 0.5))), 1e-15);
  // Apex at 0.5 (-h, h, 0), base disk about 0.5 (h, -h, 0) with extent 0.5 h in x and y.
  const Bounds cone = shape_bounds(Shape::cone, turn);
  EXPECT_LT(glm::length(cone.max - (dvec3(1, 2, 3) + dvec3(h, 0.5 * h, 0.5))), 1e-15);
  EXPECT_LT(glm::length(cone.min - (dvec3(1, 2, 3) + dvec3(-0.5 * h, -h, -0.5))), 1e-15);
}

TEST(Bounds, TransformIsTheBoxOfTheCorners) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 100; ++i) {
    const DAffine map = random_map(random);
    const Bounds box =
        unite(unite(Bounds{}, test::random_direction(random)), test::random_direction(random));
    Bounds expected;
    for (int corner = 0; corner < 8; ++corner) {
      const dvec3 p(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                    corner & 4 ? box.max.z : box.min.z);
      expected = unite(expected, map.point(p));
    }
    const Bounds result = transform(map, box);
    const double slack = 1e-13 * glm::length(map.offset);
    EXPECT_LT(glm::length(result.min - expected.min), slack);
    EXPECT_LT(glm::length(result.max - expected.max), slack);
  }
}

TEST(Bounds, EmptyStaysEmpty) {
  EXPECT_TRUE(Bounds{}.empty());
  EXPECT_TRUE(transform(DAffine{}, Bounds{}).empty());
  EXPECT_TRUE(unite(Bounds{}, Bounds{}).empty());
  const Bounds point = unite(Bounds{}, dvec3(1, 2, 3));
  EXPECT_FALSE(point.empty());
  EXPECT_EQ(unite(point, Bounds{}).min, dvec3(1, 2, 3));
  EXPECT_EQ(unite(point, Bounds{}).max, dvec3(1, 2, 3));
}

}  // namespace
}  // namespace scenefile
