#pragma once
// How much the pixels of a picture differ from their neighbors.

#include "scenefile/asset/image.h"

#include <cstdint>
#include <functional>
#include <span>

namespace scenefile {

/// How much two colors (three floats each) differ, clamped to [0, 1]: the mean of the channels'
/// squared differences. Differences on one surface count for less: they are those of light that
/// changes evenly, or of a filtered texture, and one sample in the middle tells most of them.
float contrast(const float* a, const float* b, bool one_surface);

/// Calls row(y, contrasts) for the rows of an image, on as many threads as there are: of each pixel
/// the largest contrast() with one of its eight neighbors. `surfaces`: by pixel, equal where one
/// surface is seen.
void for_each_row_of_contrasts(const Image& image, std::span<const std::uint16_t> surfaces,
                               const std::function<void(int, std::span<const float>)>& row);

}  // namespace scenefile
