#pragma once
// How much the pixels of a picture differ from their neighbors.

#include "scenefile/asset/image.h"

#include <cstdint>
#include <functional>
#include <span>

namespace scenefile {

/// How much two colors (three floats each) differ, from 0 to 1: the mean squared difference of the
/// channels, clamped to [0, 1]. Differences within one surface count less: they come from smooth
/// shading or a filtered texture, which one sample at the center captures well.
float contrast(const float* a, const float* b, bool one_surface);

/// Calls row(y, contrasts) for each row of an image, in parallel; `contrasts` is, for each pixel,
/// the largest contrast() with any of its eight neighbors. `surfaces`: by pixel; equal values mean
/// the same surface.
void for_each_row_of_contrasts(const Image& image, std::span<const std::uint16_t> surfaces,
                               const std::function<void(int, std::span<const float>)>& row);

}  // namespace scenefile
