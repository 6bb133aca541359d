#pragma once
// Parts of a picture that were never drawn: rows, columns or a rectangle of one color, while the
// rest is right. Internal to the room.

#include "scenefile/grade/causes.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace scenefile {

/// Says which part of the test picture is not drawn. Only where the reference continues across its
/// border, so that a missing object is not taken for one. `different`: Pixels::different.
std::optional<Claim> claim_of_undrawn_part(const Texture& reference, const Texture& test,
                                           const std::vector<std::uint32_t>& different);

}  // namespace scenefile
