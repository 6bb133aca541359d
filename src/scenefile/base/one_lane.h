#pragma once
// The one-lane number type for code that is written once for any number of SIMD lanes (files named
// *-inl.h): a plain double. Wider types: trace/wide-inl.h. All widths round alike, so that vector
// and scalar results are equal to the last bit.

#include <algorithm>
#include <cmath>

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

}  // namespace scenefile::one

#define SCENEFILE_LANES one
