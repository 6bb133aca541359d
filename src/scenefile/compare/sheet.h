#pragma once
// Pictures of differences.

#include "scenefile/asset/image.h"

#include <span>
#include <vector>

namespace scenefile {

/// The magma color map (S. van der Walt, N. Smith, 2015): black over violet and orange to pale
/// yellow. `value` in [0, 1].
void magma(double value, std::uint8_t* rgb);

/// The greatest difference of a channel at each pixel, as magma of its square root, so that one
/// step of 255 can still be seen. Where one picture ends before the other, all is different.
Texture heat_map(const Texture& a, const Texture& b);

/// The errors of a FlipMap as magma; empty where their number is not that of the pixels.
Texture flip_picture(const std::vector<float>& errors, int width, int height);

/// At most `width` pixels wide, by averages over what each new pixel covers; smaller pictures stay.
Texture reduced(const Texture& picture, int width);

/// Pictures beside each other, aligned at their tops, on gray with a gap of 8 pixels.
Texture side_by_side(std::span<const Texture* const> pictures);

}  // namespace scenefile
