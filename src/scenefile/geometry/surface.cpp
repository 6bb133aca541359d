#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/geometry/normals-inl.h"
#include "scenefile/geometry/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scenefile {

namespace {

using glm::dvec2;
using glm::dvec3;

using std::numbers::pi;

using one::Around;

Around around_axis(const dvec3& p) {
  return one::around_axis(one::splat3(p));
}

dvec3 vector_of(const one::V3& v) {
  return {v.x, v.y, v.z};
}

// d(point)/du at this distance from the axis; u decreases as phi increases.
dvec3 around_tangent(const Around& around, double distance) {
  return 2 * pi * distance * dvec3(around.sine, 0, -around.cosine);
}

double unit_interval(double x) {
  return std::clamp(x, 0.0, 1.0);
}

Surface sphere_surface(const dvec3& p) {
  const Around around = around_axis(p);
  const double latitude = std::atan2(p.y, around.distance);
  const double up = std::sin(latitude);
  const double out = std::cos(latitude);
  Surface s;
  s.normal = vector_of(one::sphere_normal(one::splat3(p), around));
  s.uv = dvec2(around_u(around), one::sphere_v(p.y, around));
  s.tangent_u = around_tangent(around, around.distance > 0 ? 0.5 * out : 0);
  s.tangent_v = 0.5 * pi * dvec3(-up * around.cosine, out, -up * around.sine);
  return s;
}

Surface cylinder_side(const dvec3& p) {
  const Around around = around_axis(p);
  Surface s;
  s.normal = vector_of(one::cylinder_normal(around));
  s.uv = dvec2(around_u(around), unit_interval(p.y + 0.5));
  s.tangent_u = around_tangent(around, 0.5);
  s.tangent_v = dvec3(0, 1, 0);
  return s;
}

Surface cone_side(const dvec3& p) {
  const Around around = around_axis(p);
  Surface s;
  s.normal = vector_of(one::cone_normal(around));
  s.uv = dvec2(around_u(around), unit_interval(p.y + 0.5));
  s.tangent_u = around_tangent(around, around.distance);
  s.tangent_v = dvec3(-0.5 * around.cosine, 1, -0.5 * around.sine);
  return s;
}

// A flat face, given the directions in which u and v increase.
Surface flat(const dvec3& p, const dvec3& along_u, const dvec3& along_v) {
  return {
      glm::cross(along_u, along_v),
      dvec2(unit_interval(glm::dot(p, along_u) + 0.5), unit_interval(glm::dot(p, along_v) + 0.5)),
      along_u, along_v};
}

Surface top(const dvec3& p) {
  return flat(p, dvec3(1, 0, 0), dvec3(0, 0, -1));
}

Surface bottom(const dvec3& p) {
  return flat(p, dvec3(1, 0, 0), dvec3(0, 0, 1));
}

Surface cube_surface(Face face, const dvec3& p) {
  const dvec3 up(0, 1, 0);
  switch (face) {
    case Face::pos_x:
      return flat(p, dvec3(0, 0, -1), up);
    case Face::neg_x:
      return flat(p, dvec3(0, 0, 1), up);
    case Face::pos_z:
      return flat(p, dvec3(1, 0, 0), up);
    case Face::neg_z:
      return flat(p, dvec3(-1, 0, 0), up);
    case Face::neg_y:
    case Face::bottom:
      return bottom(p);
    case Face::pos_y:
    case Face::top:
    case Face::side:
      break;
  }
  return top(p);
}

}  // namespace

Surface surface_at(Shape shape, Face face, const dvec3& point) {
  switch (shape) {
    case Shape::cube:
      return cube_surface(face, point);
    case Shape::sphere:
      return sphere_surface(point);
    case Shape::cylinder:
      return face == Face::top      ? top(point)
             : face == Face::bottom ? bottom(point)
                                    : cylinder_side(point);
    case Shape::cone:
      return face == Face::bottom ? bottom(point) : cone_side(point);
    case Shape::mesh:
      break;
  }
  return {};
}

}  // namespace scenefile
