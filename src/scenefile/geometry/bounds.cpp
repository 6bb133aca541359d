#include "scenefile/geometry/shapes.h"

#include <cmath>

namespace scenefile {

namespace {

// Half the extent along each axis of a disk of diameter 1 in the plane of two columns of a map: its
// image is an ellipse, whose support in a direction is the length of the projected axes.
glm::dvec3 disk_extent(const glm::dvec3& a, const glm::dvec3& b) {
  return 0.5 * glm::sqrt(a * a + b * b);
}

Bounds around(const glm::dvec3& center, const glm::dvec3& extent) {
  return {center - extent, center + extent};
}

Bounds cone_bounds(const DAffine& m) {
  const glm::dvec3 base = m.offset - 0.5 * m.linear[1];
  return unite(around(base, disk_extent(m.linear[0], m.linear[2])), m.offset + 0.5 * m.linear[1]);
}

}  // namespace

Bounds unite(const Bounds& a, const Bounds& b) {
  return {glm::min(a.min, b.min), glm::max(a.max, b.max)};
}

Bounds unite(const Bounds& a, const glm::dvec3& p) {
  return {glm::min(a.min, p), glm::max(a.max, p)};
}

Bounds transform(const DAffine& to_from, const Bounds& box) {
  if (box.empty()) {
    return {};
  }
  // Arvo, "Transforming Axis-Aligned Bounding Boxes", Graphics Gems (1990).
  Bounds result{to_from.offset, to_from.offset};
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 low = to_from.linear[axis] * box.min[axis];
    const glm::dvec3 high = to_from.linear[axis] * box.max[axis];
    result.min += glm::min(low, high);
    result.max += glm::max(low, high);
  }
  return result;
}

Bounds shape_bounds(Shape shape, const DAffine& to_from_object) {
  const glm::dmat3& m = to_from_object.linear;
  const glm::dvec3& center = to_from_object.offset;
  switch (shape) {
    case Shape::cube:
      return around(center, 0.5 * (glm::abs(m[0]) + glm::abs(m[1]) + glm::abs(m[2])));
    case Shape::sphere:
      return around(center, 0.5 * glm::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]));
    case Shape::cylinder:
      return around(center, 0.5 * glm::abs(m[1]) + disk_extent(m[0], m[2]));
    case Shape::cone:
      return cone_bounds(to_from_object);
    case Shape::mesh:
      break;
  }
  return {};
}

}  // namespace scenefile
