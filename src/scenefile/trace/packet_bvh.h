#pragma once
// An 8-wide BVH over the objects of a group, traversed by packets of rays, which skip subtrees that
// the whole packet misses. Nodes have no pointers: the children of entry e of a level are entries 8
// e to 8 e + 7 of the level below.

#include "scenefile/trace/scene_geometry.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace scenefile {

struct Bvh8Node {
  static constexpr int width = 8;
  static constexpr float far = std::numeric_limits<float>::max();

  alignas(32) float min[3][width];  ///< by axis; missing children are empty boxes
  alignas(32) float max[3][width];

  Bvh8Node();
  void put(int at, const FloatBox& box);
  /// The union of its boxes.
  FloatBox box() const;
};

class PacketBvh {
 public:
  /// Up to this number, shapes are tested one by one.
  static constexpr std::size_t max_linear_objects = 8;
  /// With more objects, a BVH does not pay off, because the rays of a packet are too far apart.
  static constexpr std::size_t max_objects = 65536;

  PacketBvh() = default;
  explicit PacketBvh(const std::vector<FloatBox>& boxes);

  bool empty() const { return order_.empty(); }
  /// Level 0 contains the objects; the last level is a single node.
  int levels() const { return static_cast<int>(levels_.size()); }
  const Bvh8Node& node(int level, std::uint32_t index) const { return levels_[level][index]; }
  /// The object of an entry at level 0.
  std::uint32_t object(std::uint32_t entry) const { return order_[entry]; }

 private:
  std::vector<std::vector<Bvh8Node>> levels_;
  std::vector<std::uint32_t> order_;
};

}  // namespace scenefile
