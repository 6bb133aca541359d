#pragma once
// Collects views into a file of cameras (format/read_cameras.h) for `scenefile frames --path`.

#include "scenefile/base/limits.h"
#include "scenefile/base/result.h"
#include "scenefile/scene/scene.h"

#include <cstddef>
#include <string>

namespace scenefile::viewer {

/// The file for the views of a scene, in the working directory: an absolute path to
/// chess-views.json.
std::string views_file(const std::string& scene);

/// Adds the camera to the file, one second after the last view, or creates the file. Existing views
/// do not change. Returns how many views the file has now, or why it was not changed.
Result<std::size_t> collect_view(const std::string& path, const Camera& camera,
                                 const Limits& limits);

/// Removes the last view; the file, too, if it was the only one. Returns the same.
Result<std::size_t> drop_view(const std::string& path, const Limits& limits);

}  // namespace scenefile::viewer
