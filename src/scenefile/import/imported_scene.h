#pragma once
// The result of importing another program's file.

#include "scenefile/asset/load_assets.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

#include <string>
#include <vector>

namespace scenefile {

/// A file next to the scene, which the scene refers to.
struct ImportedFile {
  std::string name;
  std::string bytes;
};

/// A scene with the files of its meshes and textures. Do not use it if errors were reported.
struct ImportedScene {
  Scene scene;
  std::vector<ImportedFile> files;
};

struct ImportOptions {
  std::string stem = "model";  ///< prefix of file names
  FetchFile fetch = {};        ///< reads files that the model refers to; empty: all are missing
  Limits limits;
};

}  // namespace scenefile
