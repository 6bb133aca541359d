#pragma once
// Aligns the items of two lists. Internal to scene.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scenefile {

/// An item of a list to be aligned with another list.
struct AlignItem {
  std::uint64_t hash = 0;  ///< of the complete item
  std::string label;       ///< items with the same label can be versions of each other
};

/// Two matching items, as indices into their lists; an item without a partner was added or removed.
struct AlignedPair {
  std::optional<std::size_t> a;
  std::optional<std::size_t> b;
  bool equal = false;  ///< the hashes are equal
  bool moved = false;  ///< equal, but in a different order relative to the others
};

/// Every item of both lists once: in the order of `a`, then the unmatched items of `b`. Takes O(n
/// log n) time.
std::vector<AlignedPair> align(const std::vector<AlignItem>& a, const std::vector<AlignItem>& b);

}  // namespace scenefile
