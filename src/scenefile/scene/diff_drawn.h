#pragma once
// Compares what two scenes draw, regardless of grouping. Internal to scene.

#include "scenefile/scene/diff.h"

#include <cstddef>
#include <vector>

namespace scenefile {

/// The differences between the objects of the root and of each template in use (nested groups are
/// ignored, their transforms are multiplied), between the lights in world space, the cameras and
/// the global data. Objects and lights are numbered by kind in the order of the first scene.
/// Requires scenes in which check() finds no error. Returns at most `most` differences.
std::vector<SceneDifference> diff_drawn(const Scene& a, const Scene& b, std::size_t most);

}  // namespace scenefile
