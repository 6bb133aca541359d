#pragma once

#include "scenefile/asset/image.h"

namespace scenefile {

/// Mean structural similarity of two pictures of the same size, in [-1, 1]; 1 if they are equal.
///
/// Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli: Image quality assessment: from error
/// visibility to structural similarity, IEEE Trans. Image Processing 13(4), 2004, as in its
/// authors' program: Gaussian window of 11x11 pixels with a standard deviation of 1.5, K1 = 0.01,
/// K2 = 0.03, L = 255, weighted (not sample) variances, averaged over all positions where the
/// window lies inside the picture. Uses luma 0.299 R + 0.587 G + 0.114 B, not rounded, and omits
/// the authors' optional downsampling of large pictures. In pictures of fewer than 11 pixels across
/// or down, pixels beyond the edge repeat the edge. Returns 0 if the sizes differ.
double ssim(const Texture& a, const Texture& b);

}  // namespace scenefile
