#pragma once
// Internal to import.

#include "scenefile/base/diagnostics.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/scene.h"

#include <string>
#include <string_view>

namespace scenefile {

/// Adds what the scene lacks: a camera that shows all of `box`, and a light above it.
void complete_scene(Scene& scene, const Bounds& box, Diagnostics& diagnostics);

/// The name of a node: whole characters, at most 200 bytes of them.
std::string node_name(std::string_view name);

/// Says that what materials emit has become their ambient color, the nearest that the format has.
void report_emission(Diagnostics& diagnostics);

}  // namespace scenefile
