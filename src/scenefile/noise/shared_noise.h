#pragma once
// Noise that neighboring pixels have in common, as if they used the same random numbers. Internal
// to noise.

#include "scenefile/noise/judge_path.h"
#include "scenefile/noise/picture_readings.h"

namespace scenefile {

/// Whether the difference is such noise. Then most blocks differ, as the mean of a block has the
/// noise of few pixels; but to both sides, by no kind of light, nowhere much more than elsewhere,
/// and differently in places that are far from each other. `places_chi2`: what factors of kinds of
/// light leave.
bool has_shared_noise(const TruthBlocks& back, const Reading& reading, const PathVerdict& verdict,
                      double places_chi2);

}  // namespace scenefile
