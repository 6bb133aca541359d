#pragma once
// Where two pictures differ most, so that a person knows where to look first.

#include "scenefile/asset/image.h"

#include <optional>

namespace scenefile {

/// A rectangle of pixels; the right and lower edges are part of it.
struct WorstRegion {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
  int x = 0;  ///< the pixel to look at; preferably one whose neighbors differ too
  int y = 0;
  double mean = 0;   ///< mean of the largest channel difference of each pixel, in 1/255
  double share = 0;  ///< share of the picture's total difference, 0..1
};

/// Nullopt if no pixel differs by more than `threshold`/255, or if the sizes differ.
std::optional<WorstRegion> worst_region(const Texture& a, const Texture& b, int threshold = 4);

}  // namespace scenefile
