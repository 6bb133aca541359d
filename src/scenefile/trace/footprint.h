#pragma once
// How wide a ray is: a cone around it, for filtering textures (fine profile).

#include "scenefile/trace/surface_point.h"
#include "scenefile/trace/texture_lookup.h"

namespace scenefile {

/// A cone around a ray: its width at t is width + spread * t, world units.
struct RayCone {
  double width = 0;
  double spread = 0;

  double width_at(double t) const { return width + spread * t; }
};

/// What a cone of that width along `direction` (unit length) covers in (u, v) around the point.
UvFootprint uv_footprint(const SurfacePoint& point, const glm::dvec3& direction, double width);

/// The cone after a mirror or refraction at the point, which curved surfaces spread. `turning`: by
/// how much the ray turns when the normal does; 2 for mirrors.
RayCone bent_cone(const SurfacePoint& point, const RayCone& cone, double t, double turning);

}  // namespace scenefile
