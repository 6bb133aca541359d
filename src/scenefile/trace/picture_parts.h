#pragma once
// A picture as parts that are drawn apart, wherever there is room, and put together again.

#include "scenefile/trace/render_options.h"

#include <cstdint>

namespace scenefile {

/// More parts of a picture than this are refused.
inline constexpr std::uint32_t most_parts = 1000000;

/// The pixels of part `index` of `count`, counted from 0. The parts cover the region and do not
/// overlap; each is a rectangle of whole tiles (pieces.h), about as many in each. Empty where there
/// are more parts than tiles.
PixelRegion part_of(const PixelRegion& region, std::uint32_t index, std::uint32_t count);

}  // namespace scenefile
