#pragma once
// The scenes that `check` and `format` work on: folders among the arguments stand for the scenes in
// them.

#include "app/command.h"
#include "scenefile/io/file.h"

#include <optional>
#include <string>
#include <vector>

namespace scenefile::app {

struct SceneFile {
  std::string path;                 ///< a scene, or the folder that cannot be used
  std::optional<Error> unreadable;  ///< why not; none: the path is to be read
};

/// The arguments in their order; in place of a folder the scenes in it and in the folders below, by
/// is_scene_name() and may_be_scene(). Says how many files of such a name it left out.
std::vector<SceneFile> scene_files(const Options& options, Context& context);

}  // namespace scenefile::app
