#pragma once

#include "scenefile/asset/image.h"

namespace scenefile {

/// How two pictures of the same size differ, over all three channels of all pixels. Floats are
/// measured in 1/255, too, but neither clamped nor rounded.
struct ImageDifference {
  double psnr_db = 99;    ///< 20 log10(255 / rms), capped at 99; 99 for equal pictures
  double mean = 0;        ///< mean absolute difference, in 1/255
  double max = 0;         ///< largest absolute difference, in 1/255; whole for 8-bit pictures
  double share_over = 0;  ///< share of pixels with a channel off by more than the threshold
};

/// Compares pictures of the same size; pictures of different sizes count as entirely different (0
/// dB). `threshold` in 1/255.
ImageDifference compare_images(const Texture& a, const Texture& b, int threshold = 8);
/// The same for floats. A value that is NaN or infinite in one picture only, or not the same in
/// both, is off by 255/255. PSNR may be negative.
ImageDifference compare_images(const Image& a, const Image& b, int threshold = 8);

}  // namespace scenefile
