#pragma once

#include "scenefile/asset/image.h"

namespace scenefile {

/// Mean structural similarity of two pictures of one size, in [-1, 1]; 1: equal.
///
/// Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli: Image quality assessment: from error
/// visibility to structural similarity, IEEE Trans. Image Processing 13(4), 2004, in the form of
/// its authors' program: gaussian window of 11x11 pixels with a standard deviation of 1.5, K1 =
/// 0.01, K2 = 0.03, L = 255, weighted (not sample) variances, the mean over all places where the
/// whole window lies in the picture. Of luma 0.299 R + 0.587 G + 0.114 B, not rounded. The authors'
/// optional reduction of large pictures is not made. In pictures of fewer than 11 pixels across or
/// down, places beyond the edge count as the pixel at it. Pictures of different sizes: 0.
double ssim(const Texture& a, const Texture& b);

}  // namespace scenefile
