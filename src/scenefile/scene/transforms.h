#pragma once
// Transforms as written, turned into maps.

#include "scenefile/base/affine.h"
#include "scenefile/scene/scene.h"

#include <optional>
#include <vector>

namespace scenefile {

/// `outer` * the map of `transform`. Angles that are multiples of 90 degrees are exact; a rotation
/// about a zero axis is no rotation; the last row of a matrix is taken as 0 0 0 1.
DAffine composed(const DAffine& outer, const Transform& transform);

/// The same for a list, factor by factor from the left. So a list that is cut in two, the rear part
/// in a node inside, gives the same bits.
DAffine composed(const DAffine& outer, const std::vector<Transform>& transforms);

/// The map as a ready scene stores it; nothing when it is not invertible there, or too large.
std::optional<Affine> storable(const DAffine& map);

}  // namespace scenefile
