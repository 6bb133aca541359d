#pragma once
// Draws a scene with both engines and measures the difference.

#include "scenefile/view/draw.h"
#include "support/load_scene.h"

#include <string>
#include <vector>

namespace scenefile::view_test {

struct Agreement {
  std::string error;    ///< an error text if there are no pictures
  double whole_db = 0;  ///< PSNR of all pixels; 99 for equal pictures
  /// Excludes pixels within two pixels of a change of object; 99 if none remain.
  double inside_db = 0;
  Image traced;
  Image drawn;
  std::vector<bool> near_outline;  ///< by pixel
};

/// Both with --profile fine and --features texture.
Agreement two_engines(GlDevice& device, const testing_support::LoadedScene& scene, int width,
                      int height);

}  // namespace scenefile::view_test
