#pragma once
// Judges a written scene, wherever it came from: a file, or code that built it.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

namespace scenefile {

/// Reports ranges, names, references, loops, degenerate cameras and transforms, limits, and values
/// that have no effect. Does not open files and does not change the scene. Takes time proportional
/// to the size of the scene. Findings about objects without a place in a file name their node.
/// Of an incomplete scene it reports what would be reported too if the file had no errors. Without
/// errors, prepare() accepts the scene. Codes: scene/codes.h.
void check(const Scene& scene, const Limits& limits, Diagnostics& diagnostics);

}  // namespace scenefile
