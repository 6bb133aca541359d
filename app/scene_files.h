#pragma once
// The input files of `check` and `format`: folders on the command line are replaced by the scenes
// in them.

#include "app/command.h"
#include "scenefile/io/file.h"

#include <optional>
#include <string>
#include <vector>

namespace scenefile::app {

struct SceneFile {
  std::string path;                 ///< a scene, or a folder that cannot be used
  std::optional<Error> unreadable;  ///< the reason; nullopt: the path can be read
};

/// The arguments in order; folders are replaced by the scenes in them and in their subfolders,
/// according to is_scene_name() and may_be_scene(). Reports how many files with such a name were
/// skipped.
std::vector<SceneFile> scene_files(const Options& options, Context& context);

}  // namespace scenefile::app
