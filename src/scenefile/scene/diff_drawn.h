#pragma once
// Compares what two scenes draw, however they group it. Internal to the room.

#include "scenefile/scene/diff.h"

#include <cstddef>
#include <vector>

namespace scenefile {

/// The differences between the objects of the root and of each template that is used (groups inside
/// them do not count, transforms do as their product), between the lights in world space, the
/// cameras and the globals. Objects and lights are numbered by kind in the order of the first
/// scene. For scenes in which check() finds no error. At most `most` differences.
std::vector<SceneDifference> diff_drawn(const Scene& a, const Scene& b, std::size_t most);

}  // namespace scenefile
