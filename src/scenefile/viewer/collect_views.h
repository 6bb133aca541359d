#pragma once
// Collects views into a file of cameras (format/read_cameras.h) for `scenefile frames --path`.

#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

#include <cstddef>
#include <string>

namespace scenefile::viewer {

struct CollectedViews {
  std::size_t count = 0;  ///< in the file now
  std::string refused;    ///< why the file was not changed, one line; empty if it was
};

/// The file for the views of a scene, in the working directory: an absolute path to
/// chess-views.json.
std::string views_file(const std::string& scene);

/// Adds the camera to the file, one second after the last view, or creates the file. Existing views
/// do not change.
CollectedViews collect_view(const std::string& path, const Camera& camera, const Limits& limits);

/// Removes the last view. If it was the only one, removes the file.
CollectedViews drop_view(const std::string& path, const Limits& limits);

}  // namespace scenefile::viewer
