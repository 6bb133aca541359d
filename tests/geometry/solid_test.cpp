#include "scenefile/geometry/solid.h"

#include "scenefile/geometry/tessellate.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace scenefile {
namespace {

constexpr std::array shapes{Shape::cube, Shape::sphere, Shape::cylinder, Shape::cone};

double number(double reach) {
  return *rc::gen::inRange(-1'000'000, 1'000'001) * 1e-6 * reach;
}

glm::dvec3 vector(double reach) {
  const double x = number(reach);
  const double y = number(reach);
  return {x, y, number(reach)};
}

void holds(const char* law, const std::function<void()>& body) {
  EXPECT_TRUE(rc::check(law, body));
}

TEST(Solid, SupportAgreesWithTheBox) {
  holds("support along an axis is the side of the box", [] {
    const Shape shape = *rc::gen::elementOf(shapes);
    const DAffine place{{vector(2), vector(2), vector(2)}, vector(5)};
    const Bounds box = shape_bounds(shape, place);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 direction(0);
      direction[axis] = 1;
      RC_ASSERT(std::abs(support(shape, place, direction) - box.max[axis]) < 1e-9);
      RC_ASSERT(std::abs(-support(shape, place, -direction) - box.min[axis]) < 1e-9);
    }
  });
}

TEST(Solid, NoPointInsideIsBeyondTheSupport) {
  holds("dot(d, p) <= support(d)", [] {
    const Shape shape = *rc::gen::elementOf(shapes);
    const glm::dvec3 p = vector(0.5);
    RC_PRE(contains(shape, p));
    const glm::dvec3 d = vector(1);
    RC_ASSERT(glm::dot(d, p) <= support(shape, {}, d) + 1e-12);
  });
}

TEST(Solid, EveryRayFromInsideHitsTheSurface) {
  holds("contains(p) iff rays both ways hit", [] {
    const Shape shape = *rc::gen::elementOf(shapes);
    const Ray ray{vector(0.7), vector(1)};
    RC_PRE(glm::length(ray.direction) > 1e-3);
    ShapeHit hit;
    const bool ahead = intersect(shape, ray, 1e-9, 1e9, hit);
    const bool behind = intersect(shape, {ray.origin, -ray.direction}, 1e-9, 1e9, hit);
    // Near the surface, the results may differ within their tolerances.
    const bool inner = contains(shape, ray.origin * (1 + 1e-5));
    const bool outer = contains(shape, ray.origin * (1 - 1e-5));
    if (inner && outer) {
      RC_ASSERT(ahead && behind);
    } else if (!inner && !outer) {
      RC_ASSERT(!(ahead && behind));
    }
  });
}

TEST(Solid, SurfacesAreNotInside) {
  EXPECT_FALSE(contains(Shape::cube, {0.5, 0, 0}));
  EXPECT_TRUE(contains(Shape::cube, {0.499, 0.499, 0.499}));
  EXPECT_FALSE(contains(Shape::sphere, {0.4, 0.4, 0}));
  EXPECT_TRUE(contains(Shape::sphere, {0.3, 0.3, 0}));
  EXPECT_FALSE(contains(Shape::cylinder, {0, -0.5, 0}));
  EXPECT_TRUE(contains(Shape::cylinder, {0.49, 0.49, 0}));
  EXPECT_TRUE(contains(Shape::cone, {0.2, 0, 0}));
  EXPECT_FALSE(contains(Shape::cone, {0.2, 0.2, 0}));
}

TEST(Solid, ClosedMeshesHaveWindingNumberOneInside) {
  holds("the winding number of a tessellation is contains()", [] {
    const Shape shape = *rc::gen::elementOf(shapes);
    const Mesh mesh = tessellate(shape, 48);
    const glm::dvec3 p = vector(0.6);
    const double turns = winding_number(mesh, p);
    RC_ASSERT(std::abs(turns - std::round(turns)) < 1e-4);
    if (contains(shape, p * 1.03)) {
      RC_ASSERT(turns > 0.5);
    } else if (!contains(shape, p * 0.97)) {
      RC_ASSERT(turns < 0.5);
    }
  });
}

TEST(Solid, OpenAndInvertedMeshesDoNotWindOnce) {
  Mesh mesh = tessellate(Shape::cube, 4);
  EXPECT_NEAR(winding_number(mesh, {0, 0, 0}), 1, 1e-9);
  Mesh open = mesh;
  open.triangles.resize(mesh.triangles.size() / 2);
  EXPECT_LT(winding_number(open, {0, 0, 0}), 0.9);
  for (auto& corners : mesh.triangles) {
    std::swap(corners[0], corners[1]);
  }
  EXPECT_NEAR(winding_number(mesh, {0, 0, 0}), -1, 1e-9);
}

}  // namespace
}  // namespace scenefile
