#pragma once
// Pictures of another angle of view. Internal to noise.

#include "scenefile/noise/picture_readings.h"

namespace scenefile {

/// How far from the middle of the picture something is: in the picture, as a multiple of where it
/// should be. Below 1: the angle of view is too large.
struct ViewScale {
  double across = 1;
  double down = 1;
};

/// The picture as it would be with the right angles; what it does not show is not usable.
LinearPicture with_right_view(const PathTruth& truth, const LinearPicture& picture,
                              const ViewScale& scale);

/// The scale of both sides, or of one of them, that makes the picture most like the truth.
ViewScale fitted_view(const TruthBlocks& back, const Reading& reading);

}  // namespace scenefile
