#include "scenefile/base/affine.h"

#include <cmath>

namespace scenefile {

namespace {

// Below this ratio of determinant to product of column lengths, rounding has flattened a float map.
constexpr double min_relative_volume = 1e-12;

bool finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

bool invertible(const DAffine& a) {
  if (!finite(a.offset)) {
    return false;
  }
  // Compares squares, to avoid square roots: large scenes call this often.
  double box = 1;
  for (int i = 0; i < 3; ++i) {
    const double square = glm::dot(a.linear[i], a.linear[i]);
    // Outside this range the inverse overflows or underflows the floats that store it.
    if (!(square > 1e-60) || !(square < 1e60)) {
      return false;
    }
    box *= square;
  }
  const double volume = glm::determinant(a.linear);
  return volume * volume > min_relative_volume * min_relative_volume * box;
}

}  // namespace scenefile
