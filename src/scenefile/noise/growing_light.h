#pragma once
// Pictures in which light grows from bounce to bounce, so that the means of paths do not converge:
// blocks cannot be compared. How the values of pixels are distributed still tells how fast light
// grows, and from which surface on. Internal to noise.

#include "scenefile/noise/block_means.h"
#include "scenefile/noise/path_meanings.h"

#include <vector>

namespace scenefile {

/// A mistake, simulated with the probability of going on and the number of samples that fit best.
struct GrowthMatch {
  Meaning meaning;
  double misfit = 0;  ///< mean square over quantiles of pixels, in variances
  double probability = 0;
  double samples = 0;  ///< per pixel
};

/// The mistakes with which light grows and pixels have the distribution of those of the picture;
/// the best first, one for each name. Empty if none fits, or if a program in which light does not
/// grow fits at another brightness.
std::vector<GrowthMatch> match_growth(const TruthBlocks& back, const LinearPicture& picture);

}  // namespace scenefile
