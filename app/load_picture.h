#pragma once
// Reads and writes pictures, for commands that compare them.

#include "app/command.h"
#include "scenefile/asset/image.h"
#include "scenefile/verbs/compare_pictures.h"

namespace scenefile::app {

struct LoadedPicture {
  std::string path;  ///< as given
  Texture picture;
  bool jpeg = false;  ///< its colors are not exactly those that were stored
  std::string error;  ///< an error message with the path; empty on success
  ExitCode status = ExitCode::fine;
};

LoadedPicture load_picture(const std::string& path, Context& context);

/// Loads the scene of --scene. If it is not usable, reports that and returns it without assets.
LoadedScene load_scene_of_pictures(const std::string& path, const Options& options,
                                   Context& context);

/// The settings of diff and grade.
CompareSettings compare_settings(const Options& options);

/// Whether the file is a picture, by its first bytes; false for files that cannot be read, and for
/// standard input.
bool is_picture_file(const std::string& path);

/// Writes a PNG file. Reports failures.
ExitCode save_picture(const std::string& path, const Texture& picture, Context& context);

}  // namespace scenefile::app
