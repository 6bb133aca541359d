#pragma once
// Pictures from files and into files, for commands that compare them.

#include "app/command.h"
#include "scenefile/asset/image.h"
#include "scenefile/verbs/compare_pictures.h"

namespace scenefile::app {

struct LoadedPicture {
  std::string path;  ///< as given
  Texture picture;
  std::string error;  ///< why there is no picture, with the path; empty: there is
  ExitCode status = ExitCode::fine;
};

LoadedPicture load_picture(const std::string& path, Context& context);

/// The scene of --scene, said and without assets where it cannot be used.
LoadedScene load_scene_of_pictures(const std::string& path, const Options& options,
                                   Context& context);

/// What diff and grade ask of pictures.
CompareSettings compare_settings(const Options& options);

/// Whether the file holds a picture, by its first bytes; what cannot be read, and standard input,
/// does not.
bool is_picture_file(const std::string& path);

/// The bytes of a PNG; none, and why, for a picture that is too large for one.
std::string png_of(const Texture& picture, std::string& error);

/// Writes a PNG. Says what went wrong.
ExitCode save_picture(const std::string& path, const Texture& picture, Context& context);

}  // namespace scenefile::app
