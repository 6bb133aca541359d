#pragma once
// A picture of the window beside the reference.

#include "scenefile/compare/measure.h"

#include <cstdint>
#include <string>

namespace scenefile::viewer {

/// What is seen of two pictures.
enum class CompareView : std::uint8_t {
  off,         ///< ours alone
  split,       ///< ours left of a line, the reference right of it
  reference,   ///< the reference alone
  difference,  ///< heat map of the greatest difference of a channel
  flip,        ///< heat map of what a viewer notices
};

struct Comparison {
  PictureMeasures measures;
  Texture difference;  ///< heat_map()
  Texture flip;        ///< flip_picture()
};

/// Takes about a second for a megapixel; give it a thread.
Comparison compare_pictures(const Texture& reference, const Texture& ours);

/// "PSNR 34.21 dB   SSIM 0.9812   FLIP 0.0312   max 77/255   2.1 % of pixels off by more than 8".
std::string measures_text(const PictureMeasures& measures);

}  // namespace scenefile::viewer
