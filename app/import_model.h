#pragma once
// Imports models of other programs as scenes.

#include "app/load.h"
#include "scenefile/import/imported_scene.h"

#include <string>
#include <vector>

namespace scenefile::app {

/// Whether the path has the extension of a model: .glb, .gltf or .obj.
bool is_model(const std::string& path);

/// The prefix for names of files next to `output`.
std::string file_stem(const std::string& output);

/// Reads and checks the model. `files` are written next to the scene, with the prefix of `output`;
/// `inputs` are the files that were read.
LoadedScene import_model(const std::string& path, const std::string& output, const Options& options,
                         std::vector<ImportedFile>& files, std::vector<std::string>& inputs,
                         Context& context);

/// Writes the scene and the files next to it: all or none. Refuses (ErrorKind::usage) to replace
/// one of `inputs` by a file next to the scene.
Result<void> write_model(const std::string& output, const std::string& text,
                         const std::vector<ImportedFile>& files,
                         const std::vector<std::string>& inputs);

}  // namespace scenefile::app
