#pragma once
// A scene on its way from a file to the window.

#include "scenefile/asset/load_assets.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/scene/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace scenefile::viewer {

struct OpenedScene {
  std::string path;        ///< as given
  std::string text;        ///< the bytes of the file
  std::string unreadable;  ///< why there is no text, one line; empty: there is
  Scene written;
  Prepared ready;  ///< empty when there are errors
  Assets assets;
  Diagnostics diagnostics;
  std::vector<std::string>
      files;  ///< paths of textures and meshes, whether they could be used or not

  /// Whether it can be drawn.
  bool usable() const { return unreadable.empty() && !diagnostics.has_errors(); }
};

/// Reads, checks, prepares and loads; called from one thread at a time, not always the same. The
/// caller decides on limits and on what may be opened.
using LoadScene = std::function<OpenedScene(const std::string& path)>;

}  // namespace scenefile::viewer
