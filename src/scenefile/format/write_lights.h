#pragma once
// Lights of a scene brought to world space as lights that a file can hold. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

#include <vector>

namespace scenefile {

/// Every light, once for each copy of the template that it stands in, in the order of prepare().
/// Lights that stand in the root itself, untransformed, are as written.
std::vector<Light> lights_in_world(const Scene& scene, const Limits& limits,
                                   Diagnostics& diagnostics);

}  // namespace scenefile
