#pragma once
// Collects views into a file of cameras (format/read_cameras.h) for `scenefile frames --path`.

#include "scenefile/base/limits.h"
#include "scenefile/base/result.h"
#include "scenefile/scene/scene.h"

#include <cstddef>
#include <optional>
#include <string>

namespace scenefile::viewer {

/// The file for the views of a scene, in the working directory: an absolute path to
/// chess-views.json.
std::string views_file(const std::string& scene);

/// Adds the camera to the file, one second after the last view, or creates the file; without a
/// camera removes the last view, and the file, too, if that was the only one. Other views do not
/// change: what the first one leaves out is that of `scene`, the scene's camera. Returns how many
/// views the file has now, or why it was not changed.
Result<std::size_t> change_views(const std::string& path, const std::optional<Camera>& added,
                                 const Camera& scene, const Limits& limits);

}  // namespace scenefile::viewer
