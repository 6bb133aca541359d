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

/// Reads and checks the model. `files` are written next to the scene, with the prefix of `output`.
/// Adds the files that are read to context.files.
LoadedScene import_model(const std::string& path, const std::string& output, const Options& options,
                         std::vector<ImportedFile>& files, Context& context);

/// Writes the scene and the files next to it: all or none. Refuses (ExitCode::usage) to replace an
/// input by a file next to the scene.
Outcome write_model(const std::string& output, const std::string& text,
                    const std::vector<ImportedFile>& files, Context& context);

}  // namespace scenefile::app
