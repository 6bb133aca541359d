#pragma once
// Saves the view as the camera of the scene file.

#include "scenefile/base/result.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/scene/scene.h"

#include <string>
#include <string_view>

namespace scenefile::viewer {

/// Sets the camera of the file at `path` with set_camera(). Returns the new contents of the file,
/// or why it was not changed: its contents differ from `known`, those last read; it is standard
/// input; it cannot be edited or written. The file is replaced atomically.
Result<std::string> save_view(const std::string& path, std::string_view known, const Camera& camera,
                              const ReadOptions& options);

/// Restores the previous contents; fails under the same conditions as save_view().
Result<std::string> restore_text(const std::string& path, std::string_view known,
                                 const std::string& before, const ReadOptions& options);

}  // namespace scenefile::viewer
