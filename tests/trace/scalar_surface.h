#pragma once
// Textures and bump maps of single points, filtered over footprints, by the formulas of the
// wavefronts for one lane.

#include "scenefile/trace/ray_differential.h"
#include "scenefile/trace/surface_point.h"
#include "scenefile/trace/texture_lookup.h"
#include "scenefile/trace/tracer.h"

#include <optional>

namespace scenefile {

/// A footprint in (u, v), a parallelogram: the derivatives of (u, v) for one step to the right and
/// one step down in the picture.
struct UvFootprint {
  glm::dvec2 right{0};
  glm::dvec2 down{0};
};

/// The footprint in (u, v) around the point with these derivatives.
UvFootprint uv_footprint(const SurfacePoint& point, const PixelDerivatives& dp);

/// The course's filter: weights are relative to the corner of the texel instead of its center,
/// which shifts the texture by half a texel.
glm::dvec3 lookup_course_filter(const Texture& texture, const RenderTexture& use,
                                const glm::dvec2& uv);

/// The average over the footprint; interpolates between texel centers if the footprint is smaller
/// than a texel. `grid`: 2 for a separate lookup in each quarter of the footprint.
glm::dvec3 lookup_filtered(const MipMap& mip_map, const RenderTexture& use, const glm::dvec2& uv,
                           const UvFootprint& footprint, int grid = 1);

/// The color of the texture at the point, if it has one that is used. `dp`: derivatives of the
/// point; `grid`: SampleKey::texture_grid.
std::optional<Color> texture_color(const Tracer& tracer, const SurfacePoint& point,
                                   const PixelDerivatives& dp, int grid);

/// The color that diffuse light is multiplied by: kd * Cd, or the texture blended over it.
Color diffuse_color(const Tracer& tracer, const RenderMaterial& material,
                    const std::optional<Color>& texture);

/// Replaces the shading normal by that of the bump map.
void apply_bump(const Tracer& tracer, SurfacePoint& point, const PixelDerivatives& dp, int grid);

}  // namespace scenefile
