#include "scenefile/format/reserve_nodes.h"

#include <algorithm>
#include <cstddef>

namespace scenefile {

void reserve_nodes(std::vector<Node>& nodes, double progress) {
  constexpr std::size_t small = 4096;
  if (nodes.size() < nodes.capacity() || nodes.size() < small) {
    return;
  }
  const auto size = static_cast<double>(nodes.size());
  const double expected = 1.02 * size / progress;
  nodes.reserve(static_cast<std::size_t>(std::clamp(expected, 1.25 * size, 16 * size)));
}

}  // namespace scenefile
