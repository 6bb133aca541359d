#include "scenefile/scene/transforms.h"

#include <cmath>
#include <variant>

namespace scenefile {

namespace {

constexpr double pi = 3.14159265358979323846;

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
  return {std::sin(turn * pi / 180), std::cos(turn * pi / 180)};
}

// Rodrigues' formula.
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

DAffine map_of(const Translate& t) {
  return {glm::dmat3(1), glm::dvec3(t.by)};
}
DAffine map_of(const Rotate& r) {
  return {rotation(r), glm::dvec3(0)};
}
DAffine map_of(const Scale& s) {
  const glm::dvec3 by(s.by);
  return {glm::dmat3(by.x, 0, 0, 0, by.y, 0, 0, 0, by.z), glm::dvec3(0)};
}
DAffine map_of(const Matrix& matrix) {
  return {glm::dmat3(glm::mat3(matrix.m())), glm::dvec3(matrix.m()[3])};
}

}  // namespace

DAffine composed(const DAffine& outer, const Transform& transform) {
  return outer * std::visit([](const auto& map) { return map_of(map); }, transform.map);
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
  // Rounding to float can flatten what was not quite flat.
  const Affine stored(map);
  if (!invertible(map) || !invertible(DAffine(stored))) {
    return std::nullopt;
  }
  return stored;
}

}  // namespace scenefile
