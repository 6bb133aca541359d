#pragma once
// The view as the camera of the scene's file.

#include "scenefile/format/read_scene.h"
#include "scenefile/scene/scene.h"

#include <string>
#include <string_view>

namespace scenefile::viewer {

struct SavedView {
  std::string text;     ///< the bytes of the file now; empty when refused
  std::string refused;  ///< why the file is as it was, one line; empty: it is saved
};

/// Sets the camera of the file at `path`, by edit_camera(). `known`: its bytes when it was read
/// last; a file that has other bytes now is left alone, as is standard input. The file is replaced
/// whole or not at all.
SavedView save_view(const std::string& path, std::string_view known, const Camera& camera,
                    const ReadOptions& options);

/// Writes the bytes that the file had before it was saved; refused as save_view() does.
SavedView restore_text(const std::string& path, std::string_view known, const std::string& before,
                       const ReadOptions& options);

}  // namespace scenefile::viewer
