#pragma once
// Bump maps (fine profile).

#include "scenefile/trace/surface_point.h"
#include "scenefile/trace/texture_lookup.h"

namespace scenefile {

/// The height of white above black, in object space units.
inline constexpr double bump_height = 1.0 / 16;

/// The shading normal (world space, unit length) of a surface displaced along its normal by
/// bump_height times the mean of red, green and blue. Slopes are central differences over one
/// texel, or over the footprint if that is wider.
glm::dvec3 bumped_normal(const SurfacePoint& point, const Pyramid& map,
                         const UvFootprint& footprint);

}  // namespace scenefile
