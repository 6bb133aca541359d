#pragma once
// The exact definition of the four analytic shapes, used everywhere: the tracer intersects them,
// the viewer draws their tessellation (tessellate.h), and a property test checks that both agree.
//
// Object space: the cube is [-1/2, 1/2]^3. The sphere has radius 1/2. The cylinder has radius 1/2
// about the y axis from y = -1/2 to 1/2, with two caps. The cone has its apex at (0, 1/2, 0) and a
// base cap of radius 1/2 at y = -1/2. (From the course's format; fitted to reference pictures.)

#include "scenefile/base/affine.h"
#include "scenefile/base/shape.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace scenefile {

/// A ray in any space. The direction need not be a unit vector; t is in units of its length.
struct Ray {
  glm::dvec3 origin{0};
  glm::dvec3 direction{0, 0, -1};
};

/// Parts of the shapes that differ in normal or uv. The sphere has only `side`; the cylinder has
/// side, top and bottom; the cone has side and bottom; the cube has the six faces named by an axis.
enum class Face : std::uint8_t { side, top, bottom, pos_x, neg_x, pos_y, neg_y, pos_z, neg_z };

struct ShapeHit {
  double t = 0;
  Face face = Face::side;
};

/// The nearest intersection of the ray with the surface at t_min < t < t_max, from outside or
/// inside, in object space. Returns false, and leaves `hit` unchanged, if there is none. Not for
/// meshes.
///
/// The solids are closed and have no gaps: a ray that enters also leaves, even through an edge, and
/// a ray in the plane of a face or cap hits it. The hit point is accurate to a few units of
/// rounding, relative to the larger of 1 and the distance of the origin. The direction may have any
/// finite length except zero. A ray with a component that is not finite hits nothing.
bool intersect(Shape shape, const Ray& ray, double t_min, double t_max, ShapeHit& hit);

/// The local surface at a point, for shading, in the space of the point.
struct Surface {
  glm::dvec3 normal{0, 1, 0};  ///< outward, unit length
  glm::dvec3 flat{0, 1, 0};    ///< the same, not interpolated between the corners of a triangle
  glm::dvec2 uv{0};            ///< in [0, 1] on shapes, as the file says on meshes; v up
  glm::dvec3 tangent_u{0};     ///< d(point)/du; zero where u is undefined (poles, apex)
  glm::dvec3 tangent_v{0};     ///< d(point)/dv; tangent_u x tangent_v points outward
};

/// Normal, uv and tangents at a point on a face of a shape. A point slightly off the surface is
/// projected to the nearest point on it. On round sides, u = 1 - phi / 2 pi with phi = atan2(z, x)
/// in [0, 2 pi) increases clockwise seen from above; v is the latitude on the sphere, and the
/// height on cylinder and cone. All formulas: docs/rendering.md. The apex of the cone has no
/// normal; (0, 1, 0) is used. Not for meshes.
Surface surface_at(Shape shape, Face face, const glm::dvec3& point);

/// An axis-aligned box; empty if min > max.
struct Bounds {
  glm::dvec3 min{1e300};
  glm::dvec3 max{-1e300};

  bool empty() const { return !(min.x <= max.x); }
};

Bounds unite(const Bounds& a, const Bounds& b);
Bounds unite(const Bounds& a, const glm::dvec3& p);
/// The bounding box of the eight transformed corners; an empty box stays empty.
Bounds transform(const DAffine& to_from, const Bounds& box);
/// The tightest bounding box of a transformed analytic shape, up to rounding. Not for meshes.
Bounds shape_bounds(Shape shape, const DAffine& to_from_object);

}  // namespace scenefile
