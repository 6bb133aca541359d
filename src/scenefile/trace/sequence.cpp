#include "scenefile/trace/sequence.h"

#include <cmath>
#include <numbers>

namespace scenefile {

namespace {

using std::numbers::pi;

}  // namespace

glm::dvec2 disk_of_square(const glm::dvec2& p) {
  const glm::dvec2 s = 2.0 * p - 1.0;
  if (s.x == 0 && s.y == 0) {
    return {0, 0};
  }
  const bool wide = std::abs(s.x) > std::abs(s.y);
  const double radius = wide ? s.x : s.y;
  const double angle = wide ? pi / 4 * (s.y / s.x) : pi / 2 - pi / 4 * (s.x / s.y);
  return radius * glm::dvec2(std::cos(angle), std::sin(angle));
}

}  // namespace scenefile
