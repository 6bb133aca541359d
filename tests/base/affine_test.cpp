#include "scenefile/base/affine.h"

#include <gtest/gtest.h>

#include <limits>

namespace scenefile {
namespace {

const DAffine shear_and_move{glm::dmat3(2, 0, 0, 1, 3, 0, 0, 0, -1), glm::dvec3(4, 5, 6)};

TEST(Affine, ProductAppliesTheRightFactorFirst) {
  const DAffine move{glm::dmat3(1), glm::dvec3(1, 0, 0)};
  const DAffine grow{glm::dmat3(2), glm::dvec3(0)};
  EXPECT_EQ((grow * move).point({0, 0, 0}), glm::dvec3(2, 0, 0));
  EXPECT_EQ((move * grow).point({0, 0, 0}), glm::dvec3(1, 0, 0));
}

TEST(Affine, InverseUndoesTheMap) {
  const glm::dvec3 p(0.3, -2, 7);
  const glm::dvec3 back = inverse(shear_and_move).point(shear_and_move.point(p));
  EXPECT_NEAR(glm::length(back - p), 0, 1e-14);
}

TEST(Affine, NormalStaysPerpendicularUnderShear) {
  const glm::dvec3 tangent(1, 1, 0);
  const glm::dvec3 normal(1, -1, 0);
  const glm::dvec3 moved = transform_normal(inverse(shear_and_move), normal);
  EXPECT_NEAR(glm::dot(moved, shear_and_move.vector(tangent)), 0, 1e-14);
}

TEST(Affine, InvertibleAtAnyScaleButNotWithoutAnAxis) {
  EXPECT_TRUE(invertible(DAffine{glm::dmat3(1e-20), glm::dvec3(0)}));
  EXPECT_TRUE(invertible(DAffine{glm::dmat3(1e20), glm::dvec3(0)}));
  EXPECT_TRUE(invertible(DAffine{glm::dmat3(-1, 0, 0, 0, 1e-6, 0, 0, 0, 1e6), glm::dvec3(0)}));
  EXPECT_FALSE(invertible(DAffine{glm::dmat3(1, 0, 0, 0, 0, 0, 0, 0, 1), glm::dvec3(0)}));
  EXPECT_FALSE(invertible(DAffine{glm::dmat3(1, 2, 3, 2, 4, 6, 0, 0, 1), glm::dvec3(0)}));
}

TEST(Affine, NotFiniteIsNotInvertible) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(invertible(DAffine{glm::dmat3(inf), glm::dvec3(0)}));
  EXPECT_FALSE(invertible(DAffine{glm::dmat3(1), glm::dvec3(0, inf, 0)}));
}

}  // namespace
}  // namespace scenefile
