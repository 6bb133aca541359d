// Each shape is convex, so a line crosses it in one interval of t, which is the overlap of the
// intervals of simpler convex sets: slabs, an infinite cylinder, a half cone. Comparing intervals
// rather than testing hit points against edges leaves no gap where two faces meet.
//
// The roots are found from the point of the line nearest to the center (apex for the cone), so
// that nothing cancels for far origins, and the discriminants are written by cross products, from
// which what the usual form cancels is already gone. Compare Haines et al., "Precision Improvements
// for Ray/Sphere Intersection", Ray Tracing Gems (2019), chapter 7.

#include "scenefile/geometry/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scenefile {

namespace {

using glm::dvec3;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double radius = 0.5;

// The part of a line inside a convex set, and the faces by which the line enters and leaves.
struct Span {
  double enter = -infinity;
  double exit = infinity;
  Face enter_face = Face::side;
  Face exit_face = Face::side;
};

constexpr Span nothing{infinity, -infinity, Face::side, Face::side};

// Cuts a span to low <= origin + t * direction <= high along one axis.
void clip(Span& span, double origin, double direction, double low, double high, Face low_face,
          Face high_face) {
  if (direction == 0) {
    if (!(origin >= low && origin <= high)) {
      span = nothing;
    }
    return;
  }
  double enter = (low - origin) / direction;
  double exit = (high - origin) / direction;
  if (direction < 0) {
    std::swap(enter, exit);
    std::swap(low_face, high_face);
  }
  if (enter > span.enter) {
    span.enter = enter;
    span.enter_face = low_face;
  }
  if (exit < span.exit) {
    span.exit = exit;
    span.exit_face = high_face;
  }
}

// The two roots of a t^2 + 2 h t + c, given the square root of h^2 - a c; in no order. The one
// that would cancel is found from the product of the roots.
struct Roots {
  double first, second;
};
Roots solve(double a, double h, double c, double root) {
  const double q = -(h + std::copysign(root, h));
  return {q / a, q == 0 ? 0 : c / q};
}

Span sphere_span(const dvec3& p, const dvec3& d) {
  // |p x d|^2 = |p|^2 |d|^2 - (p.d)^2 without its cancellation.
  const dvec3 w = glm::cross(p, d);
  const double a = glm::dot(d, d);
  const double square = radius * radius * a - glm::dot(w, w);
  if (!(square >= 0)) {
    return nothing;
  }
  const double half = std::sqrt(square);
  const double middle = -glm::dot(p, d);
  return {(middle - half) / a, (middle + half) / a, Face::side, Face::side};
}

Span cylinder_span(const dvec3& p, const dvec3& d) {
  const double a = d.x * d.x + d.z * d.z;
  const double c = p.x * p.x + p.z * p.z - radius * radius;
  Span span;
  if (a == 0) {
    span = c <= 0 ? span : nothing;
  } else {
    const double w = p.z * d.x - p.x * d.z;
    const double square = radius * radius * a - w * w;
    if (!(square >= 0)) {
      return nothing;
    }
    const Roots roots = solve(a, p.x * d.x + p.z * d.z, c, std::sqrt(square));
    span.enter = std::min(roots.first, roots.second);
    span.exit = std::max(roots.first, roots.second);
  }
  clip(span, p.y, d.y, -radius, radius, Face::bottom, Face::top);
  return span;
}

// The half of the double cone x^2 + z^2 = y^2 / 4 below its apex, which is the origin here.
Span half_cone_span(const dvec3& p, const dvec3& d) {
  const double a = d.x * d.x + d.z * d.z - 0.25 * d.y * d.y;
  const double h = p.x * d.x + p.z * d.z - 0.25 * p.y * d.y;
  const double c = p.x * p.x + p.z * p.z - 0.25 * p.y * p.y;
  const dvec3 w = glm::cross(p, d);
  const double square = 0.25 * (w.x * w.x + w.z * w.z) - w.y * w.y;
  if (a > 0) {  // flatter than the cone: both crossings are on one half
    if (!(square >= 0) || !(p.y - h / a * d.y <= 0)) {
      return nothing;
    }
    const Roots roots = solve(a, h, c, std::sqrt(square));
    return {std::min(roots.first, roots.second), std::max(roots.first, roots.second), Face::side,
            Face::side};
  }
  // Steeper: one crossing on each half, inside beyond both. Along a generator: one crossing, or
  // none (a second one at infinity).
  if (a == 0 && (h == 0 || (h < 0) != (d.y < 0))) {
    return nothing;
  }
  const Roots roots = solve(a, h, c, std::sqrt(std::max(square, 0.0)));
  const double last = a == 0 ? roots.second : std::max(roots.first, roots.second);
  const double first = a == 0 ? roots.second : std::min(roots.first, roots.second);
  return d.y < 0 ? Span{last, infinity, Face::side, Face::side}
                 : Span{-infinity, first, Face::side, Face::side};
}

Span cone_span(const dvec3& p, const dvec3& d) {
  Span span = half_cone_span(p, d);
  clip(span, p.y, d.y, -1, infinity, Face::bottom, Face::top);
  return span;
}

Span cube_span(const dvec3& p, const dvec3& d) {
  Span span;
  clip(span, p.x, d.x, -radius, radius, Face::neg_x, Face::pos_x);
  clip(span, p.y, d.y, -radius, radius, Face::neg_y, Face::pos_y);
  clip(span, p.z, d.z, -radius, radius, Face::neg_z, Face::pos_z);
  return span;
}

Span shape_span(Shape shape, const dvec3& p, const dvec3& d) {
  switch (shape) {
    case Shape::cube:
      return cube_span(p, d);
    case Shape::cone:
      return cone_span(p, d);
    case Shape::cylinder:
      return cylinder_span(p, d);
    case Shape::sphere:
      return sphere_span(p, d);
    case Shape::mesh:
      break;
  }
  return nothing;
}

bool nearest(const Span& span, double shift, double t_min, double t_max, ShapeHit& hit) {
  if (!(span.enter <= span.exit)) {
    return false;
  }
  const double enter = span.enter + shift;
  const double exit = span.exit + shift;
  if (enter > t_min && enter < t_max) {
    hit = {enter, span.enter_face};
    return true;
  }
  if (exit > t_min && exit < t_max) {
    hit = {exit, span.exit_face};
    return true;
  }
  return false;
}

// The face at which the first of equal crossings lies; `toward` where the ray leaves.
Face face_of(const dvec3& crossings, double t, const dvec3& toward) {
  constexpr Face low[3] = {Face::neg_x, Face::neg_y, Face::neg_z};
  constexpr Face high[3] = {Face::pos_x, Face::pos_y, Face::pos_z};
  const int axis = crossings.x == t ? 0 : crossings.y == t ? 1 : 2;
  return toward[axis] > 0 ? high[axis] : low[axis];
}

// The same as by cube_span, without its branches, for rays that are along no face: which way they
// go is as good as random.
bool intersect_cube(const dvec3& p, const dvec3& d, double t_min, double t_max, ShapeHit& hit) {
  const dvec3 a = (-radius - p) / d;
  const dvec3 b = (radius - p) / d;
  const dvec3 near = glm::min(a, b);
  const dvec3 far = glm::max(a, b);
  const double enter = std::max(std::max(near.x, near.y), near.z);
  const double exit = std::min(std::min(far.x, far.y), far.z);
  if (!(enter <= exit && exit > t_min && enter < t_max)) {
    return false;
  }
  if (enter > t_min) {
    hit = {enter, face_of(near, enter, -d)};
    return true;
  }
  if (exit < t_max) {
    hit = {exit, face_of(far, exit, d)};
    return true;
  }
  return false;
}

// Whether a ray surely stays outside of the sphere around a round shape. Cheap, and wide enough
// for what the rounding of the tests proper could make a hit.
bool passes_by(Shape shape, const Ray& ray, double length2, double t_min) {
  const double reach2 = shape == Shape::sphere ? 0.26 : 0.52;
  const double distance2 = glm::dot(ray.origin, ray.origin);
  if (!(distance2 < 1e12)) {
    return false;
  }
  const dvec3 w = glm::cross(ray.origin, ray.direction);
  const bool departs = t_min >= 0 && distance2 > reach2 && glm::dot(ray.origin, ray.direction) > 0;
  return departs || glm::dot(w, w) > reach2 * length2;
}

// For directions whose square, length2, neither overflows nor underflows.
bool intersect_moderate(Shape shape, const Ray& ray, double length2, double t_min, double t_max,
                        ShapeHit& hit) {
  const dvec3& d = ray.direction;
  // Nothing cancels in slabs, and rays that were exactly on an edge stay there.
  if (shape == Shape::cube) {
    if (!std::isfinite(glm::dot(ray.origin, d))) {
      return false;
    }
    return d.x != 0 && d.y != 0 && d.z != 0
               ? intersect_cube(ray.origin, d, t_min, t_max, hit)
               : nearest(cube_span(ray.origin, d), 0, t_min, t_max, hit);
  }
  if (passes_by(shape, ray, length2, t_min)) {
    return false;
  }
  const dvec3 center(0, shape == Shape::cone ? 0.5 : 0, 0);
  const dvec3 origin = ray.origin - center;
  const double shift = -glm::dot(origin, d) / length2;
  const dvec3 p = origin + shift * d;
  // No point of a shape is farther than sqrt(5/4) from its center; also refuses what is not finite.
  if (!(glm::dot(p, p) <= 1.5)) {
    return false;
  }
  return nearest(shape_span(shape, p, d), shift, t_min, t_max, hit);
}

// The same ray with its direction scaled by a power of two, which changes no digit.
bool intersect_extreme(Shape shape, const Ray& ray, double t_min, double t_max, ShapeHit& hit) {
  const dvec3 size = glm::abs(ray.direction);
  int exponent = 0;
  std::frexp(std::max({size.x, size.y, size.z}), &exponent);
  Ray scaled = ray;
  for (int axis = 0; axis < 3; ++axis) {
    scaled.direction[axis] = std::ldexp(ray.direction[axis], -exponent);
  }
  ShapeHit found;
  if (!intersect_moderate(shape, scaled, glm::dot(scaled.direction, scaled.direction),
                          std::ldexp(t_min, exponent), std::ldexp(t_max, exponent), found)) {
    return false;
  }
  found.t = std::ldexp(found.t, -exponent);
  if (!(found.t > t_min && found.t < t_max)) {
    return false;
  }
  hit = found;
  return true;
}

}  // namespace

bool intersect(Shape shape, const Ray& ray, double t_min, double t_max, ShapeHit& hit) {
  const double length2 = glm::dot(ray.direction, ray.direction);
  const bool moderate = length2 > 1e-100 && length2 < 1e100;
  return moderate ? intersect_moderate(shape, ray, length2, t_min, t_max, hit)
                  : intersect_extreme(shape, ray, t_min, t_max, hit);
}

}  // namespace scenefile
