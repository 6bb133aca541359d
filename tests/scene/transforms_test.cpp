#include "scenefile/scene/transforms.h"

#include "builders.h"
#include "expect_near.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace scenefile;
using namespace scenefile::test;

namespace {

glm::dvec3 image(const std::vector<Transform>& transforms, glm::dvec3 point) {
  return composed(DAffine(), transforms).point(point);
}

}  // namespace

TEST(Transforms, LastListedActsFirst) {
  const std::vector<Transform> list = {translate(10, 0, 0), scale(2, 2, 2)};
  EXPECT_EQ(image(list, {1, 0, 0}), glm::dvec3(12, 0, 0));
  const std::vector<Transform> reversed = {scale(2, 2, 2), translate(10, 0, 0)};
  EXPECT_EQ(image(reversed, {1, 0, 0}), glm::dvec3(22, 0, 0));
}

TEST(Transforms, RotationIsRightHandedAndInDegrees) {
  EXPECT_EQ(image({rotate({0, 0, 1}, 90)}, {1, 0, 0}), glm::dvec3(0, 1, 0));
  EXPECT_EQ(image({rotate({0, 5, 0}, 90)}, {1, 0, 0}), glm::dvec3(0, 0, -1));
  EXPECT_EQ(image({rotate({0, -1, 0}, -90)}, {1, 0, 0}), glm::dvec3(0, 0, -1));
  expect_near(image({rotate({1, 1, 1}, 120)}, {1, 0, 0}), {0, 1, 0});
  expect_near(image({rotate({0, 0, 1}, 45)}, {1, 0, 0}), {std::sqrt(0.5), std::sqrt(0.5), 0});
}

TEST(Transforms, QuarterTurnsAreExact) {
  for (const float degrees : {0.0f, 90.0f, 180.0f, 270.0f, 360.0f, -90.0f, -450.0f, 3600090.0f}) {
    const glm::dvec3 p = image({rotate({0, 0, 1}, degrees)}, {1, 0, 0});
    EXPECT_EQ(p.x, std::round(p.x)) << degrees;
    EXPECT_EQ(p.y, std::round(p.y)) << degrees;
  }
}

TEST(Transforms, AxisOfAnyLengthButZero) {
  expect_near(image({rotate({0, 0, 1e-20f}, 30)}, {1, 0, 0}), {std::sqrt(0.75), 0.5, 0});
  expect_near(image({rotate({0, 0, 1e38f}, 30)}, {1, 0, 0}), {std::sqrt(0.75), 0.5, 0});
  EXPECT_EQ(image({rotate({0, 0, 0}, 30)}, {1, 2, 3}), glm::dvec3(1, 2, 3));
}

TEST(Transforms, MatrixTranslatesByItsLastColumn) {
  glm::mat4 m(2);
  m[3] = glm::vec4(1, 2, 3, 1);
  EXPECT_EQ(image({matrix(m)}, {1, 1, 1}), glm::dvec3(3, 4, 5));
}

TEST(Transforms, CuttingAListDoesNotChangeABit) {
  const std::vector<Transform> list = {rotate({1, 2, 3}, 17), scale(0.3f, 1.7f, -2),
                                       translate(1, 2, 3), rotate({3, 1, 0}, 71)};
  const DAffine whole = composed(DAffine(), list);
  for (std::size_t cut = 0; cut <= list.size(); ++cut) {
    const std::vector<Transform> front(list.begin(), list.begin() + static_cast<long>(cut));
    const std::vector<Transform> rear(list.begin() + static_cast<long>(cut), list.end());
    EXPECT_EQ(composed(composed(DAffine(), front), rear), whole);
  }
}

TEST(Storable, RejectsValuesThatCannotBeDrawn) {
  const auto ok = [](const std::vector<Transform>& list) {
    return storable(composed(DAffine(), list)).has_value();
  };
  EXPECT_TRUE(ok({}));
  EXPECT_TRUE(ok({scale(1, 1, -1)}));
  EXPECT_TRUE(ok({scale(1, 1e-6f, 1)}));
  EXPECT_FALSE(ok({scale(1, 0, 1)}));
  EXPECT_FALSE(ok(std::vector<Transform>(400, scale(10, 10, 10))));
  EXPECT_FALSE(ok({scale(1e10f, 1, 1), translate(3e25f, 0, 0)}));
  EXPECT_FALSE(ok({matrix(glm::mat4(1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 0, 0, 0, 1))}));
  // Invertible in doubles, but its columns are parallel after rounding to floats.
  glm::mat4 shear(1);
  shear[1][0] = 1e9f;
  EXPECT_TRUE(invertible(composed(DAffine(), {rotate({0, 0, 1}, 45), matrix(shear)})));
  EXPECT_FALSE(ok({rotate({0, 0, 1}, 45), matrix(shear)}));
}
