#pragma once
// Parts of a picture that were never drawn: rows, columns, a rectangle or a grid of pixels of one
// color, while the rest is correct. Internal to grade.

#include "scenefile/grade/causes.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace scenefile {

/// The color that all pixels of a picture have, but for very few; nullopt if there is none.
std::optional<glm::ivec3> only_color(const Texture& picture);

/// A claim that the whole test picture has one color, or about the part of it that is not drawn.
/// For a part, the reference must continue across its border, so that a missing object is not
/// mistaken for one. `different`: Pixels::different.
std::optional<Claim> claim_of_undrawn_part(const Texture& reference, const Texture& test,
                                           const std::vector<std::uint32_t>& different);

}  // namespace scenefile
