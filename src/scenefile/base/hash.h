#pragma once
// A non-cryptographic hash of bytes: tells files apart and detects damage, not forgery.

#include <cstdint>
#include <string_view>

namespace scenefile {

/// A 64-bit hash of all texts added, in order, and of where each ends. Texts that differ in a
/// single byte never have the same value. The mixing step is the finalizer of SplitMix64 (Steele,
/// Lea, Flood 2014).
class Hash {
 public:
  void add(std::string_view bytes);
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0x9e3779b97f4a7c15;
};

}  // namespace scenefile
