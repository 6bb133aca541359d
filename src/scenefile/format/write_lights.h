#pragma once
// The lights of a scene in world space, as lights that a file can represent. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

#include <vector>

namespace scenefile {

/// Every light, once for each instance of its template, in the order of prepare(). Lights of the
/// root without transforms are unchanged.
std::vector<Light> lights_in_world(const Scene& scene, const Limits& limits,
                                   Diagnostics& diagnostics);

}  // namespace scenefile
