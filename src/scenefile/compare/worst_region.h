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
  int x = 0;  ///< the pixel to look at: surrounded by others that differ, where there is one
  int y = 0;
  double mean = 0;   ///< mean of the greatest channel differences in the rectangle, in 1/255
  double share = 0;  ///< share of the picture's whole difference that lies in it, 0..1
};

/// Nothing where no pixel differs by more than `threshold`/255, or where the sizes differ.
std::optional<WorstRegion> worst_region(const Texture& a, const Texture& b, int threshold = 4);

}  // namespace scenefile
