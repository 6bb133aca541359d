#pragma once
// Loads a scene from its bytes, with all findings, the same for every program. Opens no files:
// textures and meshes come from a callback (load_file.h has one for files).

#include "scenefile/asset/load_assets.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/base/result.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/scene/scene.h"
#include "scenefile/trace/render_options.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// How much to load.
enum class LoadDepth : std::uint8_t { prepared, with_meshes, with_all_assets };

struct LoadSettings {
  LoadDepth depth = LoadDepth::with_all_assets;
  bool compat_course = false;  ///< read like the course's programs (ReadOptions)
  bool allow_missing = false;  ///< a mesh that cannot be used is a warning
  bool materials = false;      ///< read the materials of mesh faces even if the scene has lights
  Limits limits;
  ForEach for_each = {};  ///< for decoding textures; empty: sequentially
  /// Called at the start of each phase, such as "reading the scene", with a static text.
  std::function<void(const char* phase)> entering = {};
};

/// A scene in all its states.
struct LoadedScene {
  std::string path;                 ///< as given; "-": standard input
  std::string text;                 ///< the contents of the file
  std::optional<Error> unreadable;  ///< why the file could not be read
  Scene written;
  Prepared ready;  ///< do not draw it if there are errors
  Assets assets;
  std::uint64_t asset_fingerprint = 0;  ///< of names and contents of all loaded files
  Diagnostics diagnostics;

  /// Whether it can be drawn.
  bool usable() const { return !unreadable && !diagnostics.has_errors(); }
};

/// Reads, checks, prepares and loads, up to settings.depth, regardless of findings. `path` is only
/// used as a name.
LoadedScene load_scene(std::string path, std::string text, const FetchFile& fetch,
                       const LoadSettings& settings = {});

/// The part of load_scene() after reading: checks, prepares and loads scene.written, in place of
/// what was loaded before. New findings are added after the existing ones.
void load_written(LoadedScene& scene, const FetchFile& fetch, const LoadSettings& settings = {});

/// Whether the scene is meant for a path tracer: it has no lights, but faces of meshes that emit
/// light.
bool lit_by_faces_only(const LoadedScene& scene);

/// Which assets a picture with these options needs.
LoadDepth depth_for(const RenderOptions& options);

/// Adds findings that concern any picture of a usable scene (placement/check_view.h).
void check_picture(LoadedScene& scene);
/// The same for a picture with these options, including findings that depend on them.
void check_picture(LoadedScene& scene, const RenderOptions& options);

/// The name of a scene in messages: <stdin> for "-".
std::string shown_name(const std::string& path);

}  // namespace scenefile
