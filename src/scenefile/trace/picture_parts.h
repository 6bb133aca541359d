#pragma once
// Divides a picture into parts that can be drawn on different machines and merged.

#include "scenefile/trace/render_options.h"

#include <cstdint>

namespace scenefile {

/// Whether the region has no pixels.
bool empty(const PixelRegion& region);

/// The maximum number of parts.
inline constexpr std::uint32_t max_parts = 1000000;

/// The pixels of part `index` of `count`, counted from 0. The parts cover the region without
/// overlap; each is a rectangle of whole tiles (pieces.h), about the same number in each. Empty if
/// there are more parts than tiles.
PixelRegion part_of(const PixelRegion& region, std::uint32_t index, std::uint32_t count);

}  // namespace scenefile
