#pragma once
// Saves the view as the camera of the scene file.

#include "scenefile/format/read_scene.h"
#include "scenefile/scene/scene.h"

#include <string>
#include <string_view>

namespace scenefile::viewer {

struct SavedView {
  std::string text;     ///< the new contents of the file; empty if refused
  std::string refused;  ///< why the file was not changed, one line; empty: saved
};

/// Sets the camera of the file at `path` with edit_camera(). Refuses if the file's contents differ
/// from `known`, those last read, and for standard input. The file is replaced atomically.
SavedView save_view(const std::string& path, std::string_view known, const Camera& camera,
                    const ReadOptions& options);

/// Restores the previous contents; refuses under the same conditions as save_view().
SavedView restore_text(const std::string& path, std::string_view known, const std::string& before,
                       const ReadOptions& options);

}  // namespace scenefile::viewer
