#pragma once
// Shared by the readers of XML and JSON. Internal to format.

#include "scenefile/scene/scene.h"

#include <glm/vec3.hpp>

#include <vector>

namespace scenefile {

/// The difference of two points, not normalized. It is scaled down if it overflows a float, because
/// only the direction matters.
glm::vec3 direction_to(const glm::vec3& to, const glm::vec3& from);

// For scenes with a million objects:

/// Makes room for another node. Reserves what the rest of the file needs, extrapolated from
/// `progress`, the fraction of the file already read (0..1). This avoids the final copy, and the
/// unused memory that doubling would leave.
void reserve_nodes(std::vector<Node>& nodes, double progress);

/// Whether a finding could refer to this color, so that its place must be stored.
bool needs_place(Field color, const glm::vec3& value);

}  // namespace scenefile
