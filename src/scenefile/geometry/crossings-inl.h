// Ray-shape intersection for any number of lanes (base/one_lane.h).
// Each shape is convex, so a line crosses it in one interval of t: the intersection of the
// intervals of simpler convex sets, such as slabs, an infinite cylinder, or a half cone. Comparing
// intervals, rather than testing hit points against edges, leaves no gap where two faces meet.
// The roots are computed relative to the point of the line nearest to the center (for the cone, to
// its apex), which avoids cancellation for distant origins. The discriminants use cross products,
// where the usual form cancels. Compare Haines et al., "Precision Improvements for Ray/Sphere
// Intersection", Ray Tracing Gems (2019), chapter 7.
//
// No include guard: included once for each number of lanes.

#include "scenefile/geometry/shapes.h"

#include <limits>

namespace scenefile::SCENEFILE_LANES {

inline constexpr double shape_radius = 0.5;

/// The nearest intersection of each lane that has one.
struct Crossing {
  M hit;
  F t;
  F face;  ///< a Face as a number
};

inline F number_of(Face face) {
  return splat(static_cast<int>(face));
}

// The part of a line inside a convex set, and the faces through which it enters and leaves.
struct Span {
  F enter, exit, enter_face, exit_face;
};

inline Span side_span(F enter, F exit) {
  return {enter, exit, number_of(Face::side), number_of(Face::side)};
}

// Cuts a span to low <= origin + t * direction <= high along one axis.
inline void clip(Span& span, F origin, F direction, double low, double high, Face low_face,
                 Face high_face) {
  const F infinity = splat(std::numeric_limits<double>::infinity());
  const F at_low = (splat(low) - origin) / direction;
  const F at_high = (splat(high) - origin) / direction;
  const M backward = direction < splat(0);
  F enter = select(backward, at_high, at_low);
  F exit = select(backward, at_low, at_high);
  const M along = direction == splat(0);
  const M inside = (origin >= splat(low)) & (origin <= splat(high));
  enter = select(along, select(inside, -infinity, infinity), enter);
  exit = select(along, select(inside, infinity, -infinity), exit);
  const F near_face = select(backward, number_of(high_face), number_of(low_face));
  const F far_face = select(backward, number_of(low_face), number_of(high_face));
  const M later = enter > span.enter;
  span.enter = select(later, enter, span.enter);
  span.enter_face = select(later, near_face, span.enter_face);
  const M sooner = exit < span.exit;
  span.exit = select(sooner, exit, span.exit);
  span.exit_face = select(sooner, far_face, span.exit_face);
}

// The two roots of a t^2 + 2 h t + c, unordered, given the square root of h^2 - a c. The root that
// would cancel is computed from the product of the roots.
struct Roots {
  F first, second;
};
inline Roots solve(F a, F h, F c, F square_root) {
  const F q = -(h + copysign(square_root, h));
  return {q / a, select(q == splat(0), splat(0), c / q)};
}

inline Span sphere_span(const V3& p, const V3& d, M& crossed) {
  // p x d|^2 equals |p|^2 |d|^2 - (p.d)^2, but without cancellation.
  const V3 w = cross(p, d);
  const F a = dot(d, d);
  const F square = splat(shape_radius * shape_radius) * a - dot(w, w);
  crossed = crossed & (square >= splat(0));
  const F half = sqrt(square);
  const F middle = -dot(p, d);
  return side_span((middle - half) / a, (middle + half) / a);
}

inline Span cylinder_span(const V3& p, const V3& d, M& crossed) {
  const F infinity = splat(std::numeric_limits<double>::infinity());
  const F a = d.x * d.x + d.z * d.z;
  const F c = p.x * p.x + p.z * p.z - splat(shape_radius * shape_radius);
  const F w = p.z * d.x - p.x * d.z;
  const F square = splat(shape_radius * shape_radius) * a - w * w;
  const M upright = a == splat(0);
  crossed = crossed & select(upright, c <= splat(0), square >= splat(0));
  const Roots roots = solve(a, p.x * d.x + p.z * d.z, c, sqrt(square));
  Span span = side_span(select(upright, -infinity, min(roots.first, roots.second)),
                        select(upright, infinity, max(roots.first, roots.second)));
  clip(span, p.y, d.y, -shape_radius, shape_radius, Face::bottom, Face::top);
  return span;
}

// The lower half of the double cone x^2 + z^2 = y^2 / 4, with the apex at the origin, cut off at
// the base.
inline Span cone_span(const V3& p, const V3& d, M& crossed) {
  const F infinity = splat(std::numeric_limits<double>::infinity());
  const F zero = splat(0);
  const F quarter = splat(0.25);
  const F a = d.x * d.x + d.z * d.z - quarter * d.y * d.y;
  const F h = p.x * d.x + p.z * d.z - quarter * p.y * d.y;
  const F c = p.x * p.x + p.z * p.z - quarter * p.y * p.y;
  const V3 w = cross(p, d);
  const F square = quarter * (w.x * w.x + w.z * w.z) - w.y * w.y;
  const Roots roots = solve(a, h, c, sqrt(max(square, zero)));
  const F lesser = min(roots.first, roots.second);
  const F greater = max(roots.first, roots.second);
  // If the ray is flatter than the cone, both roots are on one half. If it is steeper, there is one
  // on each half, and the inside lies beyond both. Parallel to a generator there is one root, or
  // none (a second root at infinity).
  const M flat = a > zero;
  const M generator = a == zero;
  const M downward = d.y < zero;
  const M on_half = (square >= zero) & (p.y - h / a * d.y <= zero);
  const M no_crossing = generator & ((h == zero) | ((h < zero) ^ downward));
  crossed = crossed & select(flat, on_half, !no_crossing);
  const F last = select(generator, roots.second, greater);
  const F first = select(generator, roots.second, lesser);
  Span span = side_span(select(flat, lesser, select(downward, last, -infinity)),
                        select(flat, greater, select(downward, infinity, first)));
  clip(span, p.y, d.y, -1, std::numeric_limits<double>::infinity(), Face::bottom, Face::top);
  return span;
}

inline Crossing nearest(const Span& span, M crossed, F shift, F t_min, F t_max) {
  const F enter = span.enter + shift;
  const F exit = span.exit + shift;
  const M front = (enter > t_min) & (enter < t_max);
  const M back = (exit > t_min) & (exit < t_max);
  const M hit = crossed & (span.enter <= span.exit) & (front | back);
  return {hit, select(front, enter, exit), select(front, span.enter_face, span.exit_face)};
}

// The interval of a ray between two opposite faces.
struct Slab {
  F near, far;
};
inline Slab slab(F origin, F direction) {
  const F infinity = splat(std::numeric_limits<double>::infinity());
  const F a = (splat(-shape_radius) - origin) / direction;
  const F b = (splat(shape_radius) - origin) / direction;
  const M along = direction == splat(0);
  if (none(along)) {
    return {min(a, b), max(a, b)};
  }
  const M inside = (origin >= splat(-shape_radius)) & (origin <= splat(shape_radius));
  return {select(along, select(inside, -infinity, infinity), min(a, b)),
          select(along, select(inside, infinity, -infinity), max(a, b))};
}

inline Crossing cube_crossing(const V3& p, const V3& d, F t_min, F t_max, M active) {
  const Slab x = slab(p.x, d.x);
  const Slab y = slab(p.y, d.y);
  const Slab z = slab(p.z, d.z);
  const F enter = max(max(x.near, y.near), z.near);
  const F exit = min(min(x.far, y.far), z.far);
  const M meets = active & (enter <= exit) & (exit > t_min) & (enter < t_max) & finite(dot(p, d));
  const M front = enter > t_min;
  const M hit = meets & (front | (exit < t_max));
  if (none(hit)) {
    return {hit, exit, exit};
  }
  const F t = select(front, enter, exit);
  // Ties go to the first axis. A ray enters through the faces that point against it.
  const auto face = [&](F direction, Face low, Face high) {
    const M ahead = (direction > splat(0)) ^ front;
    return select(ahead, number_of(high), number_of(low));
  };
  const F of_z = face(d.z, Face::neg_z, Face::pos_z);
  const F of_y = face(d.y, Face::neg_y, Face::pos_y);
  const F of_x = face(d.x, Face::neg_x, Face::pos_x);
  const M is_x = select(front, x.near, x.far) == t;
  const M is_y = select(front, y.near, y.far) == t;
  return {hit, t, select(is_x, of_x, select(is_y, of_y, of_z))};
}

// A cheap conservative test that a ray misses the bounding sphere of a round shape; its margin
// exceeds the rounding of the exact tests. A ray that points away from the center stays outside
// once it is outside at t_min, as for rays that start on the surface of a sphere.
inline M passes_by(Shape shape, const V3& origin, const V3& direction, F length2, F t_min) {
  const bool ball = shape == Shape::sphere;
  const F distance2 = dot(origin, origin);
  const F ahead = dot(origin, direction);
  const V3 w = cross(origin, direction);
  const M departs = (t_min >= splat(0)) & (ahead > splat(0)) &
                    (distance2 + splat(2) * t_min * ahead > splat(ball ? 0.25 + 1e-12 : 0.52));
  const M beside = dot(w, w) > splat(ball ? 0.26 : 0.52) * length2;
  return (distance2 < splat(1e12)) & (departs | beside);
}

// Nothing is crossed for shapes without a curved side. `p` is relative to the apex for the cone,
// otherwise to the center.
inline Span round_span(Shape shape, const V3& p, const V3& d, M& crossed) {
  switch (shape) {
    case Shape::sphere:
      return sphere_span(p, d, crossed);
    case Shape::cylinder:
      return cylinder_span(p, d, crossed);
    case Shape::cone:
      return cone_span(p, d, crossed);
    case Shape::cube:
    case Shape::mesh:
      break;
  }
  crossed = no_lanes();
  return side_span(splat(0), splat(0));
}

inline Crossing round_crossing(Shape shape, const V3& from, const V3& d, F length2, F t_min,
                               F t_max, M active) {
  M crossed = active & !passes_by(shape, from, d, length2, t_min);
  if (none(crossed)) {
    return {crossed, t_max, t_max};
  }
  const V3 origin{from.x, from.y - splat(shape == Shape::cone ? 0.5 : 0), from.z};
  const F shift = -dot(origin, d) / length2;
  const V3 p = origin + shift * d;
  // No point of a shape is farther than sqrt(5/4) from its center; this also rejects NaN and
  // infinity.
  crossed = crossed & (dot(p, p) <= splat(1.5));
  if (none(crossed)) {
    return {crossed, t_max, t_max};
  }
  const Span span = round_span(shape, p, d, crossed);
  return nearest(span, crossed, shift, t_min, t_max);
}

/// See intersect(). Not for meshes. `length2`, the squared length of the direction, must be
/// moderate().
inline Crossing crossing(Shape shape, const V3& origin, const V3& direction, F length2, F t_min,
                         F t_max, M active) {
  return shape == Shape::cube
             ? cube_crossing(origin, direction, t_min, t_max, active)
             : round_crossing(shape, origin, direction, length2, t_min, t_max, active);
}

/// Whether `length2` is in the range that crossing() requires.
inline M moderate(F length2) {
  return (length2 > splat(1e-100)) & (length2 < splat(1e100));
}

}  // namespace scenefile::SCENEFILE_LANES
