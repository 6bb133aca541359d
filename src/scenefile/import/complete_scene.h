#pragma once
// Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/scene.h"

namespace scenefile {

/// Adds a camera that shows all of `box`, and a light from above it, where the scene has none.
void complete_scene(Scene& scene, const Bounds& box, Diagnostics& diagnostics);

}  // namespace scenefile
