#pragma once
// Comparison of the window's picture with the reference.

#include "scenefile/compare/measure.h"

#include <cstdint>
#include <string>

namespace scenefile::viewer {

/// How two pictures are shown.
enum class CompareView : std::uint8_t {
  off,         ///< only ours
  split,       ///< ours left of a line, the reference right of it
  reference,   ///< only the reference
  difference,  ///< heat map of the maximum channel difference
  flip,        ///< heat map of the visible difference
};

struct Comparison {
  PictureMeasures measures;
  Texture difference;  ///< heat_map()
  Texture flip;        ///< flip_picture()
};

/// Takes about a second per megapixel; call it on another thread.
Comparison compare_pictures(const Texture& reference, const Texture& ours);

/// "PSNR 34.21 dB   SSIM 0.9812   FLIP 0.0312   max 77/255   2.1 % of pixels off by more than 8".
std::string measures_text(const PictureMeasures& measures);

}  // namespace scenefile::viewer
