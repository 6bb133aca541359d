#pragma once
// Textures and meshes of a scene that is written to another folder.

#include "app/load.h"

#include <string>

namespace scenefile::app {

/// Looks for each file of the scene from the folder of `output`. If a file is only found from the
/// scene's current folder, it gets a path relative to the folder of `output`, with a note, provided
/// that it is found that way. Otherwise (files outside the roots are never opened) a warning says
/// that the file stays behind. Does nothing for outputs without a folder, such as pipes.
void carry_files(LoadedScene& scene, const std::string& output, const Options& options);

}  // namespace scenefile::app
