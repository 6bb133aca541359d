#pragma once
// Pictures of differences, and contact sheets.

#include "scenefile/asset/image.h"

#include <span>
#include <vector>

namespace scenefile {

/// The magma color map (S. van der Walt, N. Smith, 2015): from black over violet and orange to pale
/// yellow. `value` is in [0, 1].
void magma(double value, std::uint8_t* rgb);

/// The maximum channel difference at each pixel, as magma of its square root, so that a difference
/// of 1/255 is still visible. Pixels that only one picture has count as entirely different.
Texture heat_map(const Texture& a, const Texture& b);

/// The errors of a FlipMap as magma; empty if their number is not width * height.
Texture flip_picture(const std::vector<float>& errors, int width, int height);

/// The picture scaled down to at most `width` pixels wide, by area averages; smaller pictures are
/// unchanged.
Texture reduced(const Texture& picture, int width);

/// The picture in another size: each new pixel is the mean of what it covers.
Texture scaled(const Texture& picture, int width, int height);

/// Pictures side by side on gray, with gaps of that many pixels between and around them: in columns
/// as wide as the widest picture, aligned at their upper left corners.
Texture side_by_side(std::span<const Texture* const> pictures, int gap = 8);

}  // namespace scenefile
