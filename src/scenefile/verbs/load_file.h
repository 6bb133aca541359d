#pragma once
// Scenes from the files of this machine.

#include "scenefile/io/asset_roots.h"
#include "scenefile/io/folder.h"
#include "scenefile/verbs/load_scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// Which files a scene may open beside those in its own folders (docs/assets.md).
struct AssetAccess {
  std::vector<std::string> roots;  ///< folders to look in too, in this order
  bool allow_outside = false;      ///< any file of the machine
};

/// What became of a file that the scene names.
struct AssetFile {
  AssetKind kind = AssetKind::texture;
  FileReference reference;
  ResolvedAsset resolved;
};

/// load_scene() of a file, or of standard input for "-".
LoadedScene load_scene_file(const std::string& path, const LoadSettings& settings = {},
                            const AssetAccess& access = {});

/// The same of a scene that was changed or made in memory, in place of what was loaded before: of
/// scene.written at scene.path, which need not exist.
void load_written_file(LoadedScene& scene, const LoadSettings& settings = {},
                       const AssetAccess& access = {});

/// The picture in a file. The error names the file.
Result<Texture> load_picture_file(const std::string& path, const Limits& limits = {});

/// Where the files may be that a scene at `path` names: `access`, and the folder that the
/// environment variable CS123_DATA names, which is what /course/cs123/data was on the course's
/// machines.
AssetRootsOptions asset_roots_options(const std::string& path, const AssetAccess& access,
                                      const Limits& limits);

/// What was read of an asset, as load_assets() and the importers ask for it.
FileContents contents_of(Result<std::string> bytes);

/// Where each file of the scene is, textures first.
std::vector<AssetFile> locate_files(const LoadedScene& scene, const AssetAccess& access,
                                    const Limits& limits);

/// Gives up what only messages about the file need (text, written scene, sources), for work that
/// needs the memory.
void forget_file(LoadedScene& scene);

}  // namespace scenefile
