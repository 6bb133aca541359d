#pragma once
// The way from a path to a scene that can be drawn, as all commands go it.

#include "app/command.h"
#include "scenefile/asset/load_assets.h"
#include "scenefile/io/asset_roots.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/trace/check_view.h"

#include <string>
#include <vector>

namespace scenefile::app {

/// How far to go.
enum class LoadDepth { prepared, with_meshes, with_all_assets };

/// What became of a file that the scene names.
struct AssetFile {
  AssetKind kind = AssetKind::texture;
  FileReference reference;
  ResolvedAsset resolved;
};

struct LoadedScene {
  std::string path;  ///< as given
  std::string text;
  IoError unreadable;  ///< why there is no text; empty: there is
  Scene written;
  Prepared ready;  ///< not to be drawn when there are errors
  Assets assets;
  std::uint64_t asset_fingerprint = 0;  ///< of names and bytes of all files that were loaded
  Diagnostics diagnostics;
};

/// Reads, checks, prepares and loads. Goes on until the depth is reached or errors were found.
/// `allow_missing`: a mesh that cannot be used is a warning.
LoadedScene load_scene(const std::string& path, const Options& options, LoadDepth depth,
                       bool allow_missing, Context& context);

/// Where the files may be that a scene at `path` names.
AssetRootsOptions asset_roots_options(const std::string& path, const Options& options);

/// Adds what check_view() finds about the picture, where there is one. `question` need not say
/// where things are in the file.
void check_picture(LoadedScene& scene, ViewQuestion question);

/// Gives up what only messages about the file need (text, written scene, sources), for work that
/// needs the memory.
void forget_file(LoadedScene& scene);

/// Where each file of the scene is.
std::vector<AssetFile> locate_files(const LoadedScene& scene, const Options& options);

}  // namespace scenefile::app
