#pragma once
// How far pictures are apart, apart from what sampling and rounding do.

#include "scenefile/asset/image.h"

#include <cstddef>

namespace scenefile {

struct Distance {
  double sum = 0;          ///< of the differences of all values, in 1/255
  std::size_t pixels = 0;  ///< that differ
};

/// Values count as equal within 2/255 of what the other picture has at the pixel.
Distance strict_distance(const Texture& picture, const Texture& expected);

/// Values count as equal within 2/255 of the range that the other picture has in the 3x3 pixels
/// around: edges that are sampled otherwise are no difference.
Distance tolerant_distance(const Texture& picture, const Texture& expected);

/// Every `step`-th pixel across and down, from the middle of the first cell.
Texture thinned(const Texture& picture, int step);

}  // namespace scenefile
