#pragma once
// Loads a scene file for tests that render it.

#include "scenefile/asset/load_assets.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/scene/scene.h"

#include <string>

namespace scenefile::testing_support {

struct LoadedScene {
  Scene written;
  Prepared ready;
  Assets assets;
  Diagnostics diagnostics;
  std::string error;  ///< the errors as text; empty: the scene can be drawn
};

/// Reads, checks, prepares and loads the files of a scene, as the program does.
LoadedScene load_scene(const std::string& path, bool compat_course);

/// Loads the asset files of a scene at `path`; `materials`: of faces even if it has lights.
Assets load_files(const std::string& path, const RenderScene& scene, Diagnostics& diagnostics,
                  bool materials = false);

}  // namespace scenefile::testing_support
