#pragma once
// What the readers do so that scenes of a million objects cost little. Private to the room.

#include "scenefile/scene/scene.h"

namespace scenefile {

/// Makes room for one more node: for as many as the rest of the file will need, if it goes on like
/// the part before, `progress` of it (0..1). Spares the last copy, and the memory that doubling
/// would leave unused.
void reserve_nodes(std::vector<Node>& nodes, double progress);

/// Whether a finding could be about this color of a material, so that its place is worth noting.
bool needs_place(Field color, const glm::vec3& value);

}  // namespace scenefile
