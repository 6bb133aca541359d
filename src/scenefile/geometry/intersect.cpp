#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/geometry/crossings-inl.h"
#include "scenefile/geometry/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scenefile {

namespace {

bool intersect_moderate(Shape shape, const Ray& ray, double length2, double t_min, double t_max,
                        ShapeHit& hit) {
  const one::Crossing found = one::crossing(
      shape, one::splat3(ray.origin), one::splat3(ray.direction), length2, t_min, t_max, true);
  if (found.hit) {
    hit = {found.t, static_cast<Face>(static_cast<int>(found.face))};
  }
  return found.hit;
}

// Scales the direction by a power of two, which is exact.
bool intersect_extreme(Shape shape, const Ray& ray, double t_min, double t_max, ShapeHit& hit) {
  const glm::dvec3 size = glm::abs(ray.direction);
  int exponent = 0;
  std::frexp(std::max({size.x, size.y, size.z}), &exponent);
  Ray scaled = ray;
  for (int axis = 0; axis < 3; ++axis) {
    scaled.direction[axis] = std::ldexp(ray.direction[axis], -exponent);
  }
  ShapeHit found;
  if (!intersect_moderate(shape, scaled, glm::dot(scaled.direction, scaled.direction),
                          std::ldexp(t_min, exponent), std::ldexp(t_max, exponent), found)) {
    return false;
  }
  found.t = std::ldexp(found.t, -exponent);
  if (!(found.t > t_min && found.t < t_max)) {
    return false;
  }
  hit = found;
  return true;
}

}  // namespace

bool intersect(Shape shape, const Ray& ray, double t_min, double t_max, ShapeHit& hit) {
  if (shape == Shape::mesh) {
    return false;
  }
  const double length2 = glm::dot(ray.direction, ray.direction);
  return one::moderate(length2) ? intersect_moderate(shape, ray, length2, t_min, t_max, hit)
                                : intersect_extreme(shape, ray, t_min, t_max, hit);
}

}  // namespace scenefile
