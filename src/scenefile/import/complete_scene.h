#pragma once
// Internal to import.

#include "scenefile/base/diagnostics.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/scene.h"

namespace scenefile {

/// Adds what the scene lacks: a camera that shows all of `box`, and a light above it.
void complete_scene(Scene& scene, const Bounds& box, Diagnostics& diagnostics);

/// Says that what materials emit has become their ambient color, the nearest that the format has.
void report_emission(Diagnostics& diagnostics);

}  // namespace scenefile
