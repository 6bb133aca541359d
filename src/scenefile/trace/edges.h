#pragma once
// How much the pixels of a picture differ from their neighbors.

#include "scenefile/asset/image.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace scenefile {

/// How much a pixel differs from other pixels: mean squared differences of the channels, clamped to
/// [0, 1].
struct Contrast {
  float most = 0;  ///< from the pixel that differs most
  /// The same where differences within one surface count for less: they come from smooth shading or
  /// a filtered texture, which one sample at the center captures well.
  float edges = 0;
};

/// Raises `contrast` to that of two colors, three floats each.
void raise(Contrast& contrast, const float* a, const float* b, bool one_surface);

/// The contrasts of the pixels of a row, in two arrays.
struct RowOfContrasts {
  std::vector<float> most;
  std::vector<float> edges;
};

/// Calls row(y, contrasts) for each row of an image, in parallel; `contrasts` are those of each
/// pixel with its eight neighbors. `surfaces`: by pixel; equal values mean the same surface.
void for_each_row_of_contrasts(const Image& image, std::span<const std::uint16_t> surfaces,
                               const std::function<void(int, const RowOfContrasts&)>& row);

}  // namespace scenefile
