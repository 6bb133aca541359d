#pragma once
// Pictures that show the reference at another place: in a part of the frame, shifted, or only a
// quarter of it. Internal to grade.

#include "scenefile/grade/causes.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace scenefile {

/// The color of a copy of the reference, by pixel of the test.
using Copy = std::function<glm::dvec3(int x, int y)>;

struct PlacedCopy {
  Claim claim;
  Copy color;
};

inline constexpr const char* stored_by_columns =
    "pixels are stored column by column, not row by row";
inline constexpr const char* read_by_columns = "pixels are read column by column, not row by row";

/// Whether the test picture, whose width is the reference's height, is the reference turned by a
/// quarter turn, or transposed.
std::optional<Claim> find_turned(const Texture& reference, const Texture& test);

/// Whether the test picture is a copy of the reference, scaled or shifted; not for pictures that
/// are scaled about their center, which a camera can do. `different`: Pixels::different. The result
/// must not outlive the reference.
std::optional<PlacedCopy> find_placed_copy(const Texture& reference, const Texture& test,
                                           const std::vector<std::uint32_t>& different);

}  // namespace scenefile
