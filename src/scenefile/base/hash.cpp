#include "scenefile/base/hash.h"

#include <algorithm>
#include <cstring>

namespace scenefile {

namespace {

// A bijection, so that different states stay different when the same words follow.
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

}  // namespace

void Hash::add(std::string_view bytes) {
  state_ = mixed(state_ ^ bytes.size());
  while (!bytes.empty()) {
    std::uint64_t word = 0;
    const std::size_t n = std::min(bytes.size(), sizeof word);
    std::memcpy(&word, bytes.data(), n);
    state_ = mixed(state_ ^ word);
    bytes.remove_prefix(n);
  }
}

}  // namespace scenefile
