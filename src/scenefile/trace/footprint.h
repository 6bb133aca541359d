#pragma once
// What rays cover of surfaces and textures, for filtering (fine profile): how they change from one
// pixel to the next.

#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/surface_point.h"
#include "scenefile/trace/texture_lookup.h"

namespace scenefile {

/// Changes for a step to the right in the picture, and for one down; world units.
struct PixelSteps {
  glm::dvec3 x{0};
  glm::dvec3 y{0};
};

/// How a ray changes.
struct RayDifferential {
  PixelSteps origin;
  PixelSteps direction;
};

/// Of a ray of the camera, as CameraRays::ray() has it; steps of `width` pixels.
RayDifferential camera_differential(const CameraRays& camera, const glm::dvec2& pixel,
                                    const glm::dvec2& lens, double width);

/// Of the point where a ray in that unit direction meets the surface.
PixelSteps arriving_steps(const RayDifferential& ray, const glm::dvec3& direction,
                          const SurfacePoint& point);

/// What such a step covers in (u, v) around the point.
UvFootprint uv_footprint(const SurfacePoint& point, const PixelSteps& steps);

/// Turns of the geometric normal for such steps.
PixelSteps normal_turns(const SurfacePoint& point, const PixelSteps& steps);

/// After a mirror: `steps` of the point, `normal` as the ray was mirrored at it.
RayDifferential mirrored_differential(const RayDifferential& ray, const glm::dvec3& direction,
                                      const SurfacePoint& point, const PixelSteps& steps,
                                      const glm::dvec3& normal);

/// After a refraction; `normal` against the ray, `eta` as refract_direction() has it.
RayDifferential refracted_differential(const RayDifferential& ray, const glm::dvec3& direction,
                                       const SurfacePoint& point, const PixelSteps& steps,
                                       const glm::dvec3& normal, double eta);

}  // namespace scenefile
