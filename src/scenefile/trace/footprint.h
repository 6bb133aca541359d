#pragma once
// Ray differentials and texture footprints, for filtering (fine profile). After Igehy, "Tracing Ray
// Differentials", 1999.

#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/surface_point.h"
#include "scenefile/trace/texture_lookup.h"

namespace scenefile {

/// Derivatives by x and y of the picture, for one step to the right and one step down; world units.
struct PixelDerivatives {
  glm::dvec3 dx{0};
  glm::dvec3 dy{0};
};

/// The differential of a ray.
struct RayDifferential {
  PixelDerivatives origin;
  PixelDerivatives direction;
};

/// The footprint in (u, v) around the point with these derivatives.
UvFootprint uv_footprint(const SurfacePoint& point, const PixelDerivatives& dp);

}  // namespace scenefile
