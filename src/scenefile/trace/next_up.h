#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace scenefile {

/// std::nextafter(value, infinity), inlined. Bits: the integer type of the same size.
template <typename Bits, typename Float>
Float next_up(Float value) {
  if (!(value < std::numeric_limits<Float>::infinity())) {
    return value;
  }
  if (value == 0) {
    return std::numeric_limits<Float>::denorm_min();
  }
  const auto bits = std::bit_cast<Bits>(value);
  return std::bit_cast<Float>(value > 0 ? bits + 1 : bits - 1);
}

inline float next_up(double value) {
  return next_up<std::int32_t>(static_cast<float>(value));
}

}  // namespace scenefile
