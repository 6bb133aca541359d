#include "scenefile/base/affine.h"

#include <cmath>

namespace scenefile {

namespace {

// Below this share of the box spanned by its columns, a float map has lost an axis to rounding.
constexpr double min_relative_volume = 1e-12;

bool finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

bool invertible(const DAffine& a) {
  if (!finite(a.offset)) {
    return false;
  }
  // Squares of lengths and volumes: a large scene asks often, and roots cost time.
  double box = 1;
  for (int i = 0; i < 3; ++i) {
    const double square = glm::dot(a.linear[i], a.linear[i]);
    // Outside this range the inverse does not fit the floats that it is stored in.
    if (!(square > 1e-60) || !(square < 1e60)) {
      return false;
    }
    box *= square;
  }
  const double volume = glm::determinant(a.linear);
  return volume * volume > min_relative_volume * min_relative_volume * box;
}

}  // namespace scenefile
