#pragma once
// Adjusts the texture and mesh names of a scene that is written to another folder.

#include "scenefile/verbs/load_file.h"

#include <string>

namespace scenefile {

/// Looks up each file of the scene from the folder of `output`. A file that is only found from the
/// scene's current folder gets a path relative to the folder of `output`, with a note, if it can be
/// found that way. Otherwise (files outside the roots are never opened) a warning says that the
/// file is in another folder. Does nothing for outputs without a folder, such as pipes.
void carry_files(LoadedScene& scene, const std::string& output, const AssetAccess& access,
                 const Limits& limits);

}  // namespace scenefile
