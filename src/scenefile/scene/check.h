#pragma once
// Judges a written scene, wherever it came from: a file, or code that built it.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

namespace scenefile {

/// Reports ranges, names, references, cycles, degenerate cameras and transforms, limits, and
/// design hints. Does not open files and does not change the scene. Without errors, prepare()
/// accepts the scene. Codes: scene/codes.h.
void check(const Scene& scene, const Limits& limits, Diagnostics& diagnostics);

}  // namespace scenefile
