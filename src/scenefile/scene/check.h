#pragma once
// Checks a written scene, whether it was read from a file or built by code.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

namespace scenefile {

/// Reports ranges, names, references, loops, degenerate cameras and transforms, limits, and values
/// that have no effect. Does not open files and does not change the scene. Takes time linear in the
/// size of the scene. Findings about objects without a place in a file name their node. For an
/// incomplete scene, reports only what would also be reported if the file had no errors. If it
/// reports no errors, prepare() accepts the scene. Codes: scene/codes.h.
void check(const Scene& scene, const Limits& limits, Diagnostics& diagnostics);

}  // namespace scenefile
