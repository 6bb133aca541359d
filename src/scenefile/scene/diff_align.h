#pragma once
// Pairs the items of two lists. Internal to the room.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scenefile {

/// An item of a list that is to be compared with another list.
struct AlignItem {
  std::uint64_t hash = 0;  ///< of all that the item holds
  std::string label;       ///< items of one label are versions of each other rather than new ones
};

/// Two items that belong together, as indices into their lists; without one, the other is new.
struct AlignedPair {
  std::optional<std::size_t> a;
  std::optional<std::size_t> b;
  bool equal = false;  ///< by hash
  bool moved = false;  ///< equal, but in another place among the others
};

/// Every item of both lists once, in the order of `a`, the new items of `b` behind. In time n log
/// n.
std::vector<AlignedPair> align(const std::vector<AlignItem>& a, const std::vector<AlignItem>& b);

}  // namespace scenefile
