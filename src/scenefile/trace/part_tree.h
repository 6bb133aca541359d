#pragma once
// A BVH of a group's parts for bundles of rays, which can skip subtrees that a whole bundle misses.
// Nodes have eight children and no pointers: the children of entry e of a level are entries 8 e to
// 8 e + 7 of the level below.

#include "scenefile/trace/parts.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace scenefile {

struct BoxNode {
  static constexpr int width = 8;
  static constexpr float far = std::numeric_limits<float>::max();

  alignas(32) float min[3][width];  ///< by axis; missing children are empty boxes
  alignas(32) float max[3][width];

  BoxNode();
  void put(int at, const FloatBox& box);
  /// The union of its boxes.
  FloatBox box() const;
};

class PartTree {
 public:
  /// Up to this number, shapes are tested one by one.
  static constexpr std::size_t fewest_parts = 8;
  /// With more parts, a BVH does not pay off, because the rays of bundles are too far apart.
  static constexpr std::size_t max_parts = 65536;

  PartTree() = default;
  explicit PartTree(const std::vector<FloatBox>& boxes);

  bool empty() const { return order_.empty(); }
  /// Level 0 contains the parts; the last level is a single node.
  int levels() const { return static_cast<int>(levels_.size()); }
  const BoxNode& node(int level, std::uint32_t index) const { return levels_[level][index]; }
  /// The part of an entry at level 0.
  std::uint32_t part(std::uint32_t entry) const { return order_[entry]; }

 private:
  std::vector<std::vector<BoxNode>> levels_;
  std::vector<std::uint32_t> order_;
};

}  // namespace scenefile
