#pragma once
// Reads and writes pictures, for commands that compare them.

#include "app/command.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/verbs/compare_pictures.h"

#include <optional>
#include <span>
#include <string>

namespace scenefile::app {

struct LoadedPicture {
  std::string path;  ///< as given
  DecodedPicture picture;
  std::string error;  ///< an error message with the path; empty on success
  ExitCode status = ExitCode::fine;
};

/// `layer`: of EXR files with layers.
LoadedPicture load_picture(const std::string& path, const std::string& layer, Context& context);

/// Loads the scene of --scene. If it is not usable, reports that and returns it without assets.
LoadedScene load_scene_of_pictures(const std::string& path, const Options& options,
                                   Context& context);

/// The settings of diff and grade.
CompareSettings compare_settings(const Options& options);

/// Whether the file is a picture, by its first bytes, or by its name if it does not begin like a
/// scene; false for standard input.
bool is_picture_file(const std::string& path);

/// Writes a PNG file. Reports failures.
ExitCode save_picture(const std::string& path, const Texture& picture, Context& context);

}  // namespace scenefile::app
/// Writes the map to --heatmap, and the pictures next to each other to --sheet, if they are given.
/// Reports failures.
ExitCode save_maps(const Options& options, const Texture& map,
                   std::span<const Texture* const> sheet, Context& context);
