#pragma once

#include "scenefile/geometry/shapes.h"

#include <algorithm>

namespace scenefile {

/// Whether the closed box contains the point.
inline bool holds(const Bounds& box, const glm::dvec3& p) {
  return glm::all(glm::lessThanEqual(box.min, p)) && glm::all(glm::lessThanEqual(p, box.max));
}

/// Clips [t0, t1], parameters along the ray, to the part inside the box. Returns false if nothing
/// remains. Slabs; a direction of 0 along an axis is allowed.
inline bool clip_to_box(const Ray& ray, const Bounds& box, double& t0, double& t1) {
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis];
    const double d = ray.direction[axis];
    if (d == 0) {
      if (o < box.min[axis] || o > box.max[axis]) {
        return false;
      }
      continue;
    }
    const double inverse = 1 / d;
    const double a = (box.min[axis] - o) * inverse;
    const double b = (box.max[axis] - o) * inverse;
    t0 = std::max(t0, std::min(a, b));
    t1 = std::min(t1, std::max(a, b));
  }
  return t0 <= t1;
}

}  // namespace scenefile
