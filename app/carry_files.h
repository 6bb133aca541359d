#pragma once
// Textures and meshes of a scene that is written into another folder.

#include "app/load.h"

#include <string>

namespace scenefile::app {

/// Looks for each file of the scene from the folder of `output` as well. One that is found only
/// from where the scene is now is named anew, relative to the folder of `output`, when it is found
/// so, with a note; where it is not (what lies outside the roots is never opened), a warning says
/// that the file stays behind. Does nothing for outputs without a folder, such as a pipe.
void carry_files(LoadedScene& scene, const std::string& output, const Options& options);

}  // namespace scenefile::app
