#include "scenefile/trace/scene_geometry.h"

#include "scenefile/trace/next_up.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

Bounds widened(const Bounds& box) {
  const glm::dvec3 own = glm::max(glm::abs(box.min), glm::abs(box.max));
  const glm::dvec3 pad(5e-7 * std::max({own.x, own.y, own.z}) + 1e-300);
  return {box.min - pad, box.max + pad};
}

// Scales coordinates that are too large for single precision, or for Embree, to about one.
double scale_of(const Bounds& box) {
  const glm::dvec3 reach = glm::max(glm::abs(box.min), glm::abs(box.max));
  const double largest = std::max({reach.x, reach.y, reach.z});
  return largest > 1e12 ? std::exp2(-std::ceil(std::log2(largest))) : 1;
}

// An upper bound for the factor by which vectors become longer (the Frobenius norm).
double largest_stretch(const DAffine& map) {
  const glm::dmat3& m = map.linear;
  return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

}  // namespace

FloatBox padded(const Bounds& box, const Bounds& group) {
  const glm::dvec3 reach = glm::max(glm::abs(group.min), glm::abs(group.max));
  const glm::dvec3 own = glm::max(glm::abs(box.min), glm::abs(box.max));
  const double largest = std::max({reach.x, reach.y, reach.z});
  const double own_largest = std::max({own.x, own.y, own.z});
  const double size = glm::length(box.max - box.min);
  const double pad = std::max(1e-6 * own_largest, std::min(1e-6 * largest, 0.02 * size));
  FloatBox result{};
  for (int axis = 0; axis < 3; ++axis) {
    result.min[axis] = -next_up(pad - box.min[axis]);
    result.max[axis] = next_up(box.max[axis] + pad);
  }
  return result;
}

Bounds scaled(const Bounds& box, double by) {
  return {by * box.min, by * box.max};
}

Extent extent_of(const Bounds& box) {
  if (box.empty()) {
    return {};
  }
  return {widened(box), glm::length(box.max - box.min), scale_of(box)};
}

double mesh_reach(const std::vector<Group>& groups, std::uint32_t root) {
  std::vector<double> longest(groups.size(), 0);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (const Object& object : groups[g].objects) {
      const double within = object.kind == ObjectKind::mesh       ? 1
                            : object.kind == ObjectKind::instance ? longest[object.target]
                                                                  : 0;
      if (within > 0) {
        const double stretch = largest_stretch(inverse(DAffine(object.object_from_group)));
        longest[g] = std::max(longest[g], within * stretch);
      }
    }
  }
  return groups.empty() ? 1 : std::max(1.0, longest[root]);
}

}  // namespace scenefile
