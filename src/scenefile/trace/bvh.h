#pragma once
// A bounding volume hierarchy over boxes.
//
// A binary tree, split by the surface area heuristic with bins (Wald, "On fast Construction of
// SAH-based Bounding Volume Hierarchies", 2007). Boxes are in single precision, rays in double; the
// search is conservative: it skips no box that a ray hits, wherever the ray starts.

#include "scenefile/geometry/shapes.h"
#include "scenefile/trace/scene_geometry.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace scenefile {

class Bvh {
 public:
  explicit Bvh(const std::vector<FloatBox>& boxes);

  /// Calls visit(index) for the boxes that the ray may hit at t_min <= t <= end(), roughly from
  /// near to far. `end` may decrease during the search; minus infinity stops it. Origin and
  /// direction must be finite, and the direction not zero.
  template <typename End, typename Visit>
  void search(const Ray& ray, double t_min, const End& end, const Visit& visit) const;

 private:
  // A range of `count` items in items_; if count is 0, the index of an inner node.
  struct Child {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  struct Node {
    FloatBox box[2];
    Child child[2];
  };
  static_assert(sizeof(Node) == 64);
  struct Work;

  // Beyond this depth the heuristic is replaced by halving.
  static constexpr int max_levels = 64;
  static constexpr int max_waiting = max_levels + 32 + 1;

  Child make(Work& work, std::uint32_t first, std::uint32_t last, int level);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> items_;
  FloatBox whole_{};
  Child root_;
};

/// A ray prepared for box tests.
class BoxRay {
 public:
  explicit BoxRay(const Ray& ray) : origin_(ray.origin), inverse_(1.0 / ray.direction) {
    for (int axis = 0; axis < 3; ++axis) {
      backward_[axis] = std::signbit(inverse_[axis]);
    }
  }

  /// The t where the ray enters the box between t_min and end; infinity if it does not.
  double enter(const FloatBox& box, double t_min, double end) const {
    double near = t_min;
    double far = end;
    for (int axis = 0; axis < 3; ++axis) {
      const double low = (double{box.min[axis]} - origin_[axis]) * inverse_[axis];
      const double high = (double{box.max[axis]} - origin_[axis]) * inverse_[axis];
      // NaN if the ray lies in the plane of a face; the interval is then unchanged.
      const double first = backward_[axis] ? high : low;
      const double last = backward_[axis] ? low : high;
      near = first > near ? first : near;
      far = last < far ? last : far;
    }
    // Both may be off by a few units of rounding.
    constexpr double slack = 2e-15;
    return near <= far + slack * std::abs(far) ? near : std::numeric_limits<double>::infinity();
  }

 private:
  glm::dvec3 origin_;
  glm::dvec3 inverse_;
  bool backward_[3];
};

template <typename End, typename Visit>
void Bvh::search(const Ray& ray, double t_min, const End& end, const Visit& visit) const {
  constexpr double never = std::numeric_limits<double>::infinity();
  struct Waiting {
    double enter;
    Child child;
  };
  const BoxRay prepared(ray);
  std::array<Waiting, max_waiting> waiting;
  std::size_t count = 0;
  const auto push = [&](double enter, Child child) {
    if (enter != never) {
      waiting[count++] = {enter, child};
    }
  };
  if (!items_.empty()) {
    push(prepared.enter(whole_, t_min, end()), root_);
  }
  while (count > 0) {
    const Waiting next = waiting[--count];
    if (!(next.enter <= end())) {
      continue;
    }
    for (std::uint32_t i = 0; i < next.child.count; ++i) {
      visit(items_[next.child.first + i]);
    }
    if (next.child.count == 0) {
      const Node& node = nodes_[next.child.first];
      const double enter[2] = {prepared.enter(node.box[0], t_min, end()),
                               prepared.enter(node.box[1], t_min, end())};
      const int near = enter[1] < enter[0] ? 1 : 0;
      push(enter[1 - near], node.child[1 - near]);
      push(enter[near], node.child[near]);
    }
  }
}

}  // namespace scenefile
