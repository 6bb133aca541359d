#pragma once
// Converts written transforms to affine maps.

#include "scenefile/base/affine.h"
#include "scenefile/scene/scene.h"

#include <optional>
#include <vector>

namespace scenefile {

/// `outer` * the map of `transform`. Rotations by multiples of 90 degrees are exact; a rotation
/// about a zero axis is the identity; the last row of a matrix is taken as 0 0 0 1.
DAffine composed(const DAffine& outer, const Transform& transform);

/// The same for a list, multiplied from the left one by one. Moving the end of the list into a
/// child node therefore gives the same bits.
DAffine composed(const DAffine& outer, const std::vector<Transform>& transforms);

/// The map in the precision of a render scene; nullopt if it is not invertible there, or too large.
std::optional<Affine> storable(const DAffine& map);

}  // namespace scenefile
