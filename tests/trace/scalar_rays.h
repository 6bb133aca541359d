#pragma once
// Directions and differentials of single rays, by the formulas of the wavefronts for one lane.

#include "scenefile/trace/optics.h"
#include "scenefile/trace/ray_differential.h"
#include "scenefile/trace/surface_point.h"
#include "scenefile/trace/tracer.h"

namespace scenefile {

/// Smallest t of a ray that starts on a surface at `point` with a direction of unit length.
double start_offset(const Tracer& tracer, const glm::dvec3& point, double distance);

/// The reflected direction; the sign of the normal does not matter.
glm::dvec3 reflect_direction(const glm::dvec3& direction, const glm::dvec3& normal);

/// Snell's law for unit vectors: `normal` points against `direction`; `eta` is the ratio of the
/// indices of refraction, incident over transmitted side. Returns false at total internal
/// reflection.
bool refract_direction(const glm::dvec3& direction, const glm::dvec3& normal, double eta,
                       glm::dvec3& refracted);

/// The differential of a camera ray, as for CameraRays::ray(); a step is `width` pixels.
RayDifferential camera_differential(const CameraRays& camera, const glm::dvec2& pixel,
                                    const glm::dvec2& lens, double width);

/// The derivatives of the point where a ray with that unit direction hits the surface.
PixelDerivatives hit_derivatives(const RayDifferential& ray, const glm::dvec3& direction,
                                 const SurfacePoint& point);

/// The derivatives of the geometric normal. `dp`: of the point.
PixelDerivatives normal_derivatives(const SurfacePoint& point, const PixelDerivatives& dp);

/// After a reflection. `dp`: of the point; `normal`: the one used for the
/// reflection.
RayDifferential mirrored_differential(const RayDifferential& ray, const glm::dvec3& direction,
                                      const SurfacePoint& point, const PixelDerivatives& dp,
                                      const glm::dvec3& normal);

/// After a refraction. `normal` points against the ray; `eta` as for refract_direction().
RayDifferential refracted_differential(const RayDifferential& ray, const glm::dvec3& direction,
                                       const SurfacePoint& point, const PixelDerivatives& dp,
                                       const glm::dvec3& normal, double eta);

}  // namespace scenefile
