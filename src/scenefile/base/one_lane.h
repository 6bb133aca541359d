#pragma once
// The one-lane number type for code that is written once for any number of SIMD lanes (files named
// *-inl.h): a plain double. Wider types: trace/wide-inl.h. All widths round alike, so that vector
// and scalar results are equal to the last bit.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace scenefile::one {

using F = double;                ///< a number in each lane
using M = bool;                  ///< a boolean in each lane
inline constexpr int lanes = 1;  ///< number of lanes

/// The same number in all lanes.
inline F splat(double x) {
  return x;
}
inline F select(M m, F yes, F no) {
  return m ? yes : no;
}
inline M select(M m, M yes, M no) {
  return m ? yes : no;
}
inline bool any(M m) {
  return m;
}
inline bool none(M m) {
  return !m;
}
inline bool every(M m) {
  return m;
}
inline M no_lanes() {
  return false;
}
inline F sqrt(F x) {
  return std::sqrt(x);
}
inline F floor(F x) {
  return std::floor(x);
}
inline F abs(F x) {
  return std::abs(x);
}
inline F copysign(F x, F sign) {
  return std::copysign(x, sign);
}
inline F min(F a, F b) {
  return std::min(a, b);
}
inline F max(F a, F b) {
  return std::max(a, b);
}
/// Calls f for the numbers of each lane of the mask, 0 elsewhere.
template <typename Function>
F each(M m, const Function& f, F x, F y) {
  return m ? f(x, y) : 0.0;
}

// For arrays of numbers (trace/wavefront_memory.h).

/// A mask of lanes 0 to count - 1.
inline M first_lanes(std::size_t count) {
  return count != 0;
}
/// From and to memory that is aligned for it.
inline F load(const double* from) {
  return *from;
}
inline void store(F x, double* to) {
  *to = x;
}
inline F load_floats(const float* from) {
  return *from;
}
/// Extracts a byte of each number; 0 is the lowest.
template <int byte>
F load_byte(const std::int32_t* from) {
  return *from >> (8 * byte) & 255;
}
/// x / 255 for bytes.
inline F share_of_255(F x) {
  return x / 255;
}
/// One bit per lane.
inline unsigned bits(M m) {
  return m ? 1 : 0;
}
inline M of_bits(unsigned mask) {
  return (mask & 1) != 0;
}
/// The next larger number for positive numbers; infinity is unchanged.
inline F next_up(F x) {
  return x < std::numeric_limits<double>::infinity()
             ? std::bit_cast<double>(std::bit_cast<std::int64_t>(x) + 1)
             : x;
}
inline double min_of_lanes(F x) {
  return x;
}
inline double greatest_lane(F x) {
  return x;
}
/// In any order.
inline double sum_of_lanes(F x) {
  return x;
}

}  // namespace scenefile::one

#define SCENEFILE_LANES one
