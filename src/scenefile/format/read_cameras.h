#pragma once
// Camera paths in JSON (docs/many-machines.md):
//
//   {"fps": 24,
//    "views": [{"time": 0, "position": [5, 2, 5], "focus": [0, 0, 0], "up": [0, 1, 0]},
//              {"time": 3, "position": [-5, 2, 5], "focus": [0, 0, 0], "heightAngle": 30}]}
//
// The keys of a view are those of cameraData in scenes, plus `time` in seconds.

#include "scenefile/base/limits.h"
#include "scenefile/base/result.h"
#include "scenefile/scene/camera_path.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

struct CameraPath {
  std::vector<CameraView> views;  ///< at least one, by increasing time
  std::optional<double> fps;      ///< frames per second, above 0 and up to 1000
};

/// Reads a camera path. A view inherits missing values from the previous one, the first from
/// `camera`; the default for `time` is one second after the previous view. An error text starts
/// with line and column.
Result<CameraPath> read_cameras(std::string_view text, const Camera& camera, const Limits& limits);

/// Writes views so that read_cameras() reads them back unchanged.
std::string write_cameras(const CameraPath& path);

}  // namespace scenefile
