#pragma once
// Textures and bump maps of single points. The wavefronts of trace do the same in lanes.

#include "scenefile/trace/footprint.h"
#include "scenefile/trace/surface_point.h"
#include "scenefile/trace/tracer.h"

#include <optional>

namespace scenefile {

/// The color of the texture at the point, if it has one that is used. `dp`: derivatives of the
/// point, see footprint.h; `grid`: SampleKey::texture_grid.
std::optional<Color> texture_color(const Tracer& tracer, const SurfacePoint& point,
                                   const PixelDerivatives& dp, int grid);

/// The color that diffuse light is multiplied by: kd * Cd, or the texture blended over it.
Color diffuse_color(const Tracer& tracer, const RenderMaterial& material,
                    const std::optional<Color>& texture);

/// Replaces the shading normal by that of the bump map.
void apply_bump(const Tracer& tracer, SurfacePoint& point, const PixelDerivatives& dp, int grid);

}  // namespace scenefile
