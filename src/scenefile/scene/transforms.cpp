#include "scenefile/scene/transforms.h"

#include <cmath>
#include <numbers>
#include <variant>

namespace scenefile {

namespace {

struct SinCos {
  double sin;
  double cos;
};

SinCos sin_cos_degrees(double degrees) {
  const double turn = std::fmod(degrees, 360.0);
  const double quarters = turn / 90.0;
  if (quarters == std::floor(quarters)) {
    switch ((static_cast<int>(quarters) + 4) % 4) {
      case 0:
        return {0, 1};
      case 1:
        return {1, 0};
      case 2:
        return {0, -1};
      default:
        return {-1, 0};
    }
  }
  return {std::sin(turn * std::numbers::pi / 180), std::cos(turn * std::numbers::pi / 180)};
}

// Rodrigues' rotation formula.
glm::dmat3 rotation(const Rotate& rotate) {
  const glm::dvec3 axis(rotate.axis);
  const double length = glm::length(axis);
  if (!(length > 0)) {
    return glm::dmat3(1);
  }
  const glm::dvec3 k = axis / length;
  const auto [s, c] = sin_cos_degrees(rotate.angle_deg);
  const glm::dmat3 cross(0, k.z, -k.y, -k.z, 0, k.x, k.y, -k.x, 0);
  return c * glm::dmat3(1) + s * cross + (1 - c) * glm::outerProduct(k, k);
}

// Skips multiplications by 0 and 1.
DAffine product(const DAffine& outer, const Translate& t) {
  return {outer.linear, outer.point(glm::dvec3(t.by))};
}
DAffine product(const DAffine& outer, const Rotate& r) {
  return {outer.linear * rotation(r), outer.offset};
}
DAffine product(const DAffine& outer, const Scale& s) {
  const glm::dvec3 by(s.by);
  const glm::dmat3& m = outer.linear;
  return {glm::dmat3(m[0] * by.x, m[1] * by.y, m[2] * by.z), outer.offset};
}
DAffine product(const DAffine& outer, const Matrix& matrix) {
  return outer * DAffine(glm::dmat3(glm::mat3(matrix.m())), glm::dvec3(matrix.m()[3]));
}

}  // namespace

DAffine composed(const DAffine& outer, const Transform& transform) {
  return std::visit([&](const auto& map) { return product(outer, map); }, transform.map);
}

DAffine composed(const DAffine& outer, const std::vector<Transform>& transforms) {
  DAffine map = outer;
  for (const Transform& transform : transforms) {
    map = composed(map, transform);
  }
  return map;
}

std::optional<Affine> storable(const DAffine& map) {
  const double reach =
      glm::max(glm::abs(map.offset.x), glm::max(glm::abs(map.offset.y), glm::abs(map.offset.z)));
  if (!(reach < 1e30)) {
    return std::nullopt;
  }
  // Rounding to float can make a nearly flat map singular.
  const Affine stored(map);
  if (!invertible(map) || !invertible(DAffine(stored))) {
    return std::nullopt;
  }
  return stored;
}

}  // namespace scenefile
