#pragma once
// The four analytic shapes, exactly. One definition for all users: the tracer intersects them, the
// viewer draws the tessellation of tessellate.h, a property test ties the two.
//
// Object space: cube [-1/2, 1/2]^3; sphere of radius 1/2; cylinder of radius 1/2 about the y axis
// between y = -1/2 and 1/2 with two caps; cone with its apex at (0, 1/2, 0) and a base cap of
// radius 1/2 at y = -1/2. (Course format; fitted against reference pictures.)

#include "scenefile/base/affine.h"
#include "scenefile/base/shape.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace scenefile {

/// A ray in any space; the direction need not be a unit vector, t counts in its lengths.
struct Ray {
  glm::dvec3 origin{0};
  glm::dvec3 direction{0, 0, -1};
};

/// Parts of the shapes that differ in normal or uv. The sphere has `side` alone, the cylinder
/// side, top and bottom, the cone side and bottom, the cube the six that are named by an axis.
enum class Face : std::uint8_t { side, top, bottom, pos_x, neg_x, pos_y, neg_y, pos_z, neg_z };

struct ShapeHit {
  double t = 0;
  Face face = Face::side;
};

/// Nearest crossing of the ray with the surface at t_min < t < t_max, from outside or inside.
/// Returns false, and leaves `hit` alone, when there is none. All of object space. Not for meshes.
///
/// The solids are closed and have no gaps: a ray that enters leaves again, also through an edge,
/// and a ray in the plane of a face or cap touches it. The hit point lies on the surface to a few
/// units of rounding of the larger of 1 and the distance of the origin. A direction of any finite
/// length but zero will do; a ray with a number that is not finite hits nothing.
bool intersect(Shape shape, const Ray& ray, double t_min, double t_max, ShapeHit& hit);

/// What shading needs at a point of a surface, in the space of the point.
struct Surface {
  glm::dvec3 normal{0, 1, 0};  ///< outward, unit length
  glm::dvec2 uv{0};            ///< in [0, 1] on shapes, as the file says on meshes; v up
  glm::dvec3 tangent_u{0};     ///< d(point)/du; zero where u is undefined (poles, apex)
  glm::dvec3 tangent_v{0};     ///< d(point)/dv; tangent_u x tangent_v points outward
};

/// Normal, uv and tangents of a point on a face of a shape. A point a little off the surface is
/// taken for the one nearest to it. On round sides u = 1 - phi / 2 pi with phi = atan2(z, x) in
/// [0, 2 pi) grows clockwise seen from above; v is the latitude on the sphere, the height on
/// cylinder and cone. All formulas: docs/rendering.md. The apex of the cone has no normal: (0, 1,
/// 0) stands in. Not for meshes.
Surface surface_at(Shape shape, Face face, const glm::dvec3& point);

/// Axis-aligned box; empty when min > max.
struct Bounds {
  glm::dvec3 min{1e300};
  glm::dvec3 max{-1e300};

  bool empty() const { return !(min.x <= max.x); }
};

Bounds unite(const Bounds& a, const Bounds& b);
Bounds unite(const Bounds& a, const glm::dvec3& p);
/// The box around the eight transformed corners; of an empty box the empty one.
Bounds transform(const DAffine& to_from, const Bounds& box);
/// The tightest box around a transformed analytic shape, to rounding. Not for meshes.
Bounds shape_bounds(Shape shape, const DAffine& to_from_object);

}  // namespace scenefile
