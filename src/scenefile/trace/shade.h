#pragma once
// The lighting equation at a point, without reflection and refraction.

#include "scenefile/trace/footprint.h"
#include "scenefile/trace/surface_point.h"
#include "scenefile/trace/tracer.h"

namespace scenefile {

/// Selects the random numbers of a ray; equal keys give equal pictures.
struct SampleKey {
  std::uint32_t sample = 0;         ///< of the pixel, from 0
  std::uint32_t pattern = 0;        ///< different for each pixel and each reflection
  std::uint32_t light_samples = 1;  ///< points on each area light (fine profile)
  int texture_grid = 1;             ///< 2: a lookup in each quarter of a footprint (fine)
};

/// The course profile samples the centers of a grid with this many cells along each side of an area
/// light.
inline constexpr std::uint32_t course_light_side = 4;

/// Whether the light is used in this mode: the course's ray caster only uses directional lights.
bool shines_in(const Tracer& tracer, const RenderLight& light);

/// The color that diffuse light is multiplied by: kd * Cd, or the texture blended over it. `steps`:
/// derivatives of the point, see footprint.h; `grid`: see SampleKey. Notifies the recorder of
/// texture lookups.
Color diffuse_color(const Tracer& tracer, const SurfacePoint& point, const PixelSteps& steps,
                    int grid, Recorder* recorder);

/// Replaces the shading normal by that of the bump map.
void apply_bump(const Tracer& tracer, SurfacePoint& point, const PixelSteps& steps, int grid);

/// The ambient, diffuse and specular light that the point reflects against `direction`, the unit
/// direction of the ray that hit it. Applies the bump map to the shading normal.
Color shade(const Tracer& tracer, SurfacePoint& point, const glm::dvec3& direction,
            const PixelSteps& steps, const SampleKey& key, RayCounts& counts);

}  // namespace scenefile
