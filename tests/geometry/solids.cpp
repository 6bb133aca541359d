#include "geometry/solids.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scenefile::test {

namespace {

using std::numbers::pi;

double cube_axis(const glm::dvec3& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - 0.5;
}

FacePoint on_cube(Face face, double u, double v) {
  const double x = u - 0.5;
  const double y = v - 0.5;
  switch (face) {
    case Face::pos_x:
      return {{0.5, y, -x}, {u, v}};
    case Face::neg_x:
      return {{-0.5, y, x}, {u, v}};
    case Face::pos_y:
      return {{x, 0.5, -y}, {u, v}};
    case Face::neg_y:
      return {{x, -0.5, y}, {u, v}};
    case Face::pos_z:
      return {{x, y, 0.5}, {u, v}};
    default:
      return {{-x, y, -0.5}, {u, v}};
  }
}

// a is the angle of the point as a fraction of a turn, clockwise from +x seen from above; at 1/2,
// phi = atan2(z, x) is discontinuous.
FacePoint on_side(Shape shape, double a, double b) {
  const double phi = -2 * pi * a;
  double radius = 0.5;
  double y = b - 0.5;
  if (shape == Shape::sphere) {
    const double latitude = pi * (b - 0.5);
    radius = 0.5 * std::cos(latitude);
    y = 0.5 * std::sin(latitude);
  } else if (shape == Shape::cone) {
    radius = 0.5 * (1 - b);
  }
  return {{radius * std::cos(phi), y, radius * std::sin(phi)}, {a, b}};
}

FacePoint on_cap(bool top, double a, double b) {
  const double radius = 0.5 * std::sqrt(b);
  const double x = radius * std::cos(2 * pi * a);
  const double z = radius * std::sin(2 * pi * a);
  return top ? FacePoint{{x, 0.5, z}, {x + 0.5, 0.5 - z}}
             : FacePoint{{x, -0.5, z}, {x + 0.5, z + 0.5}};
}

}  // namespace

const char* name_of(Shape shape) {
  switch (shape) {
    case Shape::cube:
      return "cube";
    case Shape::cone:
      return "cone";
    case Shape::cylinder:
      return "cylinder";
    case Shape::sphere:
      return "sphere";
    case Shape::mesh:
      break;
  }
  return "mesh";
}

double implicit(Shape shape, const glm::dvec3& p) {
  const double round = std::hypot(p.x, p.z);
  switch (shape) {
    case Shape::cube:
      return cube_axis(p);
    case Shape::cone:
      return std::max(round - (0.5 - p.y) / 2, -0.5 - p.y);
    case Shape::cylinder:
      return std::max(round - 0.5, std::abs(p.y) - 0.5);
    case Shape::sphere:
      return std::hypot(p.x, p.y, p.z) - 0.5;
    case Shape::mesh:
      break;
  }
  return 1;
}

std::vector<Face> faces_of(Shape shape) {
  switch (shape) {
    case Shape::cube:
      return {Face::pos_x, Face::neg_x, Face::pos_y, Face::neg_y, Face::pos_z, Face::neg_z};
    case Shape::cone:
      return {Face::side, Face::bottom};
    case Shape::cylinder:
      return {Face::side, Face::top, Face::bottom};
    default:
      return {Face::side};
  }
}

FacePoint point_on(Shape shape, Face face, double a, double b) {
  if (shape == Shape::cube) {
    return on_cube(face, a, b);
  }
  return face == Face::side ? on_side(shape, a, b) : on_cap(face == Face::top, a, b);
}

RandomPoint random_point(Shape shape, std::mt19937_64& random) {
  const std::vector<Face> faces = faces_of(shape);
  const Face face = faces[random() % faces.size()];
  const double a = uniform(random);
  return {face, point_on(shape, face, a, uniform(random))};
}

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

glm::dvec3 random_direction(std::mt19937_64& random) {
  while (true) {
    const glm::dvec3 v(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
    const double length = glm::length(v);
    if (length > 0.01 && length <= 1) {
      return v / length;
    }
  }
}

}  // namespace scenefile::test
