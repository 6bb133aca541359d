#pragma once
// Pictures that show the reference at another place: in a part of the frame, shifted, or only a
// quarter of it. Internal to grade.

#include "scenefile/grade/causes.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace scenefile {

/// A claim that the test picture is a copy of the reference, scaled or shifted; not for pictures
/// that are scaled about their center, which a camera can do. `different`: Pixels::different.
std::optional<Claim> claim_of_placed_copy(const Texture& reference, const Texture& test,
                                          const std::vector<std::uint32_t>& different);

}  // namespace scenefile
