// Compares the BVH with testing every box.

#include "scenefile/trace/bvh.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace scenefile {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Random = std::mt19937;

double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// Some are flat, some are nested, some are equal.
std::vector<FloatBox> random_boxes(Random& random) {
  std::vector<FloatBox> boxes(random() % 400);
  for (FloatBox& box : boxes) {
    if (&box != boxes.data() && random() % 8 == 0) {
      box = (&box)[-1];
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) {
      const double size = random() % 4 == 0 ? 0 : between(random, 0, 1);
      const double at = random() % 4 == 0 ? 0 : between(random, -5, 5);
      box.min[axis] = static_cast<float>(at);
      box.max[axis] = static_cast<float>(at + size);
    }
  }
  return boxes;
}

glm::dvec3 point_in(Random& random, const FloatBox& box) {
  glm::dvec3 p;
  for (int axis = 0; axis < 3; ++axis) {
    p[axis] = between(random, 0, 1) * (double{box.max[axis]} - double{box.min[axis]}) +
              double{box.min[axis]};
  }
  return p;
}

glm::dvec3 random_direction(Random& random) {
  glm::dvec3 d;
  do {
    for (int axis = 0; axis < 3; ++axis) {
      d[axis] = random() % 3 == 0 ? 0.0 : between(random, -1, 1);
    }
  } while (d == glm::dvec3(0));
  return d;
}

RC_GTEST_PROP(Bvh, VisitsEveryBoxThatTheRayHits, ()) {
  Random random(*rc::gen::arbitrary<unsigned>());
  const std::vector<FloatBox> boxes = random_boxes(random);
  const Bvh bvh(boxes);
  for (std::uint32_t i = 0; i < boxes.size(); i += 1 + static_cast<std::uint32_t>(random() % 64)) {
    // Through a point of the box, at t = distance.
    const double distance = i % 3 == 0 ? 1e6 : between(random, 0, 10);
    Ray ray;
    ray.direction = random_direction(random);
    ray.origin = point_in(random, boxes[i]) - distance * ray.direction;
    // The hit point, within the precision of the origin.
    const double off = 1e-9 * (1 + distance);
    std::set<std::uint32_t> offered;
    std::vector<FloatBox> wide = boxes;
    for (FloatBox& box : wide) {
      for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] -= static_cast<float>(off) + 1e-5f;
        box.max[axis] += static_cast<float>(off) + 1e-5f;
      }
    }
    Bvh(wide).search(
        ray, distance - 1e-3, [&] { return distance + 1e-3; },
        [&](std::uint32_t box) { RC_ASSERT(offered.insert(box).second); });
    RC_ASSERT(offered.contains(i));
  }
}

RC_GTEST_PROP(Bvh, VisitsEachBoxOnce, ()) {
  Random random(*rc::gen::arbitrary<unsigned>());
  const std::vector<FloatBox> boxes = random_boxes(random);
  const Bvh bvh(boxes);
  Ray ray;
  ray.origin = {between(random, -9, 9), between(random, -9, 9), between(random, -9, 9)};
  ray.direction = random_direction(random);
  const BoxRay prepared(ray);
  std::multiset<std::uint32_t> offered;
  bvh.search(
      ray, 0, [] { return infinity; }, [&](std::uint32_t box) { offered.insert(box); });
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    RC_ASSERT(offered.count(i) <= 1);
    RC_ASSERT(offered.contains(i) || prepared.enter(boxes[i], 0, infinity) == infinity);
  }
}

TEST(Bvh, AnEndOfMinusInfinityEndsTheSearch) {
  const std::vector<FloatBox> boxes(1000, FloatBox{{-1, -1, -1}, {1, 1, 1}});
  const Bvh bvh(boxes);
  int offered = 0;
  bvh.search(
      {{0, 0, 5}, {0, 0, -1}}, 0, [&] { return offered > 0 ? -infinity : infinity; },
      [&](std::uint32_t) { ++offered; });
  EXPECT_GE(offered, 1);
  EXPECT_LE(offered, 4);  // the boxes of one leaf
}

TEST(Bvh, ManyBoxesInOnePlaceNestNoDeeperThanHalving) {
  std::vector<FloatBox> boxes;
  for (int i = 0; i < 100000; ++i) {
    // Each half as large as the previous one, until all are equal.
    const float size = std::ldexp(1.0f, -std::min(i, 140));
    boxes.push_back({{0, 0, 0}, {size, size, size}});
  }
  const Bvh bvh(boxes);
  int offered = 0;
  bvh.search(
      {{-1, -1, -1}, {1, 1, 1}}, 0, [] { return infinity; }, [&](std::uint32_t) { ++offered; });
  EXPECT_EQ(offered, 100000);
}

TEST(Bvh, AnEmptyTreeHasNoHits) {
  const Bvh bvh({});
  bvh.search(
      {{0, 0, 5}, {0, 0, -1}}, 0, [] { return infinity; }, [](std::uint32_t) { FAIL(); });
}

}  // namespace
}  // namespace scenefile
