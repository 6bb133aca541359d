#pragma once
// A fingerprint of bytes: for telling files apart and finding damage, not against forgery.

#include <cstdint>
#include <string_view>

namespace scenefile {

/// 64 bits that depend on every byte of all texts added, on their order and on where each ends.
/// Texts that differ in one byte alone never have the same value. The mixing step
/// is the finalizer of SplitMix64 (Steele, Lea, Flood 2014).
class Hash {
 public:
  void add(std::string_view bytes);
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0x9e3779b97f4a7c15;
};

}  // namespace scenefile
