#pragma once
// What becomes of another program's file.

#include "scenefile/asset/load_assets.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

#include <string>
#include <vector>

namespace scenefile {

/// A file that lies beside the scene and that the scene names.
struct ImportedFile {
  std::string name;
  std::string bytes;
};

/// A scene with the files of its meshes and textures. Not to be used when errors were reported.
struct ImportedScene {
  Scene scene;
  std::vector<ImportedFile> files;
};

struct ImportOptions {
  std::string stem = "model";  ///< what the names of files begin with
  FetchFile fetch = {};        ///< files that the model names; empty: all are missing
  Limits limits;
};

}  // namespace scenefile
