#pragma once
// Files of cameras that move (docs/many-machines.md): JSON.
//
//   {"fps": 24,
//    "views": [{"time": 0, "position": [5, 2, 5], "focus": [0, 0, 0], "up": [0, 1, 0]},
//              {"time": 3, "position": [-5, 2, 5], "focus": [0, 0, 0], "heightAngle": 30}]}
//
// The words of a view are those of cameraData in scenes, and `time` in seconds.

#include "scenefile/base/limits.h"
#include "scenefile/base/result.h"
#include "scenefile/scene/camera_path.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

struct CameraPath {
  std::vector<CameraView> views;  ///< at least one, in the order of increasing times
  std::optional<double> fps;      ///< frames in a second, above 0 and up to 1000
};

/// Reads such a file. What a view does not say is as in the view before, for the first as in
/// `camera`; without a time it is a second after the view before. The error begins with line and
/// column.
Result<CameraPath> read_cameras(std::string_view text, const Camera& camera, const Limits& limits);

/// Writes such a file, which read_cameras() reads as the same views.
std::string write_cameras(const CameraPath& path);

}  // namespace scenefile
