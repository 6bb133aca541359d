#pragma once
// A scene loaded from a file for the window.

#include "scenefile/asset/load_assets.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/scene/scene.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace scenefile::viewer {

struct OpenedScene {
  std::string path;        ///< as given
  std::string text;        ///< the bytes of the file
  std::string unreadable;  ///< why the file could not be read, one line; empty: it was read
  Scene written;
  Prepared ready;  ///< empty if there are errors
  Assets assets;
  Diagnostics diagnostics;
  std::vector<std::string> files;  ///< paths of textures and meshes, even of unusable ones

  /// Of the file, or the default camera.
  Camera camera() const { return written.camera.value_or(Camera{}); }
  /// Whether path tracing alone shows it.
  bool lit_by_faces_only() const {
    return ready.scene.lights.empty() && has_emissive_faces(assets);
  }
  /// Whether it can be drawn.
  bool usable() const { return unreadable.empty() && !diagnostics.has_errors(); }
};

struct SceneRequest {
  std::string path;
  std::optional<std::string> text{};  ///< instead of the file's
  bool materials = false;             ///< read those of mesh faces even if the scene has lights
};

/// Reads, checks, prepares and loads a scene; called on any thread, also concurrently. The caller
/// sets the limits and what may be opened.
using LoadScene = std::function<OpenedScene(const SceneRequest&)>;

}  // namespace scenefile::viewer
