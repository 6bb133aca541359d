#pragma once
// Parts of a picture that were never drawn: rows, columns, a rectangle or a grid of pixels of one
// color, while the rest is correct. Internal to grade.

#include "scenefile/grade/causes.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace scenefile {

/// A claim about the part of the test picture that is not drawn. Requires that the reference
/// continues across the border of that part, so that a missing object is not mistaken for one.
/// `different`: Pixels::different.
std::optional<Claim> claim_of_undrawn_part(const Texture& reference, const Texture& test,
                                           const std::vector<std::uint32_t>& different);

}  // namespace scenefile
