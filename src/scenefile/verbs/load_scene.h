#pragma once
// From the bytes of a scene to what can be drawn, with all findings on the way, as every program
// does it. Opens no files: textures and meshes come through a callback (load_file.h has one for
// the files of a machine).

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

/// How far to go.
enum class LoadDepth : std::uint8_t { prepared, with_meshes, with_all_assets };

struct LoadSettings {
  LoadDepth depth = LoadDepth::with_all_assets;
  bool compat_course = false;  ///< read as the course's programs did (ReadOptions)
  bool allow_missing = false;  ///< a mesh that cannot be used is a warning
  Limits limits;
  ForEach for_each = {};  ///< decodes textures; empty: one after the other
  /// Told what begins, such as "reading the scene", in words that stay where they are.
  std::function<void(const char* phase)> entering = {};
};

/// A scene in all of its states.
struct LoadedScene {
  std::string path;                 ///< as given; "-": standard input
  std::string text;                 ///< its bytes
  std::optional<Error> unreadable;  ///< why there are no bytes
  Scene written;
  Prepared ready;  ///< not to be drawn when there are errors
  Assets assets;
  std::uint64_t asset_fingerprint = 0;  ///< of names and bytes of all files that were loaded
  Diagnostics diagnostics;

  /// Whether it can be drawn.
  bool usable() const { return !unreadable && !diagnostics.has_errors(); }
};

/// Reads, checks, prepares and loads, as far as settings.depth says, whatever is found on the way.
/// `path` is only a name.
LoadedScene load_scene(std::string path, std::string text, const FetchFile& fetch,
                       const LoadSettings& settings = {});

/// The part of load_scene() after reading: checks, prepares and loads scene.written, in place of
/// what was loaded before. Findings come after those that are there already.
void load_written(LoadedScene& scene, const FetchFile& fetch, const LoadSettings& settings = {});

/// What a picture with these options looks at.
LoadDepth depth_for(const RenderOptions& options);

/// Adds findings about what any picture of a usable scene would show (trace/check_view.h).
void check_picture(LoadedScene& scene);
/// The same of the picture that these options ask for, and what they make doubtful or certain.
void check_picture(LoadedScene& scene, const RenderOptions& options);

/// The name of a scene in messages: <stdin> for "-".
std::string shown_name(const std::string& path);

}  // namespace scenefile
