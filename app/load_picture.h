#pragma once
// Reads and writes pictures, for commands that compare them.

#include "app/command.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/verbs/compare_pictures.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace scenefile::app {

/// A file that is or may be a picture.
struct PictureInput {
  std::string path;  ///< as given
  /// What it contains; nullopt: not read yet.
  std::optional<Result<std::string>> bytes = {};
};

struct LoadedPicture {
  std::string path;  ///< as given
  DecodedPicture picture;
  std::string error;  ///< an error message with the path; empty on success
  ExitCode status = ExitCode::fine;
};

/// `layer`: of EXR files with layers.
LoadedPicture load_picture(const PictureInput& input, const std::string& layer, Context& context);

/// Loads the scene of --scene. If it is not usable, reports that and returns it without assets.
LoadedScene load_scene_of_pictures(const std::string& path, const Options& options,
                                   Context& context);

/// The profiles that a picture may have: the given one, or all of the ray tracer.
std::vector<RenderOptions> possible_profiles(const Options& options);
/// The settings of diff and grade.
CompareSettings compare_settings(const Options& options);

/// Looks for causes as diff does, in pictures without errors. The first one is the reference.
/// `asked`: CompareSettings::asked.
PictureComparison compare_loaded(const LoadedPicture& a, const LoadedPicture& b,
                                 const LoadedScene* scene, const Options& options, Context& context,
                                 std::optional<glm::ivec2> asked = {});

/// Reads the file, unless it may be readable only once, such as standard input.
PictureInput read_ahead(const std::string& path);
/// Whether the file is a picture, by its first bytes, or by its name if it does not begin like a
/// scene; false if it was not read.
bool is_picture(const PictureInput& input);

/// Writes a PNG file. Reports failures.
ExitCode save_picture(const std::string& path, const Texture& picture, Context& context);
/// Writes the map to --heatmap, and the pictures next to each other to --sheet, if they are given.
/// Reports failures.
ExitCode save_maps(const Options& options, const Texture& map,
                   std::span<const Texture* const> sheet, Context& context);

/// Adds a member about the picture of diff.
void add_picture(Json& json, std::string_view key, const LoadedPicture& loaded);
/// Ends diff: prints `text`, unless it is empty. `written`: the result of writing maps. If that
/// failed, the answer of --json is that error (main.cpp).
ExitCode answer_comparison(const Options& options, bool same, ExitCode written,
                           const std::string& text);

}  // namespace scenefile::app
