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
  if (!finite(a.linear[0]) || !finite(a.linear[1]) || !finite(a.linear[2]) || !finite(a.offset)) {
    return false;
  }
  // Columns are normalized first so that neither tiny nor huge scales under- or overflow.
  glm::dmat3 unit;
  for (int i = 0; i < 3; ++i) {
    const double length = glm::length(a.linear[i]);
    // Outside this range the inverse does not fit the floats that it is stored in.
    if (!(length > 1e-30) || !(length < 1e30)) {
      return false;
    }
    unit[i] = a.linear[i] / length;
  }
  return std::abs(glm::determinant(unit)) > min_relative_volume;
}

}  // namespace scenefile
