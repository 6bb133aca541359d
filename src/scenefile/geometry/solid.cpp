#include "scenefile/geometry/solid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scenefile {

namespace {

using std::numbers::pi;
constexpr double margin = 1e-6;

// For the untransformed shape.
double support(Shape shape, const glm::dvec3& direction) {
  const glm::dvec3 d = glm::abs(direction);
  const double disk = std::hypot(d.x, d.z);
  switch (shape) {
    case Shape::cube:
      return 0.5 * (d.x + d.y + d.z);
    case Shape::sphere:
      return 0.5 * glm::length(d);
    case Shape::cylinder:
      return 0.5 * (d.y + disk);
    case Shape::cone:
      return 0.5 * std::max(direction.y, disk - direction.y);
    case Shape::mesh:
      break;
  }
  return 0;
}

}  // namespace

double support(Shape shape, const DAffine& to_from_object, const glm::dvec3& direction) {
  return glm::dot(direction, to_from_object.offset) +
         support(shape, glm::transpose(to_from_object.linear) * direction);
}

bool contains(Shape shape, const glm::dvec3& p) {
  const double half = 0.5 - margin;
  const bool between = std::abs(p.y) < half;
  const double radius = std::hypot(p.x, p.z);
  switch (shape) {
    case Shape::cube:
      return between && std::abs(p.x) < half && std::abs(p.z) < half;
    case Shape::sphere:
      return glm::length(p) < half;
    case Shape::cylinder:
      return between && radius < half;
    case Shape::cone:
      return between && radius < (0.5 - p.y) / 2 - margin;
    case Shape::mesh:
      break;
  }
  return false;
}

double winding_number(const Mesh& mesh, const glm::dvec3& point) {
  double half_angles = 0;
  for (const auto& corners : mesh.triangles) {
    const glm::dvec3 a = glm::dvec3(mesh.positions[corners[0]]) - point;
    const glm::dvec3 b = glm::dvec3(mesh.positions[corners[1]]) - point;
    const glm::dvec3 c = glm::dvec3(mesh.positions[corners[2]]) - point;
    const double la = glm::length(a);
    const double lb = glm::length(b);
    const double lc = glm::length(c);
    const double volume = glm::dot(a, glm::cross(b, c));
    half_angles += std::atan2(
        volume, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
  }
  return half_angles / (2 * pi);
}

}  // namespace scenefile
