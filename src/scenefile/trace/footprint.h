#pragma once
// Ray differentials and texture footprints, for filtering (fine profile). After Igehy, "Tracing Ray
// Differentials", 1999.

#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/surface_point.h"
#include "scenefile/trace/texture_lookup.h"

namespace scenefile {

/// Derivatives for one step to the right and one step down in the picture; world units.
struct PixelSteps {
  glm::dvec3 x{0};
  glm::dvec3 y{0};
};

/// The differential of a ray.
struct RayDifferential {
  PixelSteps origin;
  PixelSteps direction;
};

/// The footprint in (u, v) around the point for these steps.
UvFootprint uv_footprint(const SurfacePoint& point, const PixelSteps& steps);

}  // namespace scenefile
