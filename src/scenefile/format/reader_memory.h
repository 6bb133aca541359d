#pragma once
// Optimizations of the readers for scenes with a million objects. Private to the room.

#include "scenefile/scene/scene.h"

namespace scenefile {

/// Makes room for another node. Reserves what the rest of the file needs, extrapolated from
/// `progress`, the fraction of the file already read (0..1). This avoids the final copy, and the
/// unused memory that doubling would leave.
void reserve_nodes(std::vector<Node>& nodes, double progress);

/// Whether a finding could refer to this color, so that its place must be stored.
bool needs_place(Field color, const glm::vec3& value);

}  // namespace scenefile
