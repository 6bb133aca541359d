#pragma once
// Memory for the nodes of a scene while it is read. Internal to format.

#include "scenefile/scene/scene.h"

#include <vector>

namespace scenefile {

/// Makes room for another node. Reserves what the rest of the file needs, extrapolated from
/// `progress`, the fraction of the file already read (0..1). This avoids the final copy, and the
/// unused memory that doubling would leave.
void reserve_nodes(std::vector<Node>& nodes, double progress);

}  // namespace scenefile
