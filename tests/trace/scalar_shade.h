#pragma once
// The lighting equation at a point, without reflection and refraction.

#include "scenefile/trace/camera_rays.h"
#include "trace/recorder.h"
#include "trace/scalar_surface.h"

namespace scenefile {

/// The ambient, diffuse and specular light that the point reflects against `direction`, the unit
/// direction of the ray that hit it. Applies the bump map to the shading normal.
Color shade(const Tracer& tracer, SurfacePoint& point, const glm::dvec3& direction,
            const PixelDerivatives& dp, const SampleKey& key, ScalarCounts& counts);

}  // namespace scenefile
