#pragma once
// Loads scenes from files.

#include "scenefile/asset/image_file.h"
#include "scenefile/io/asset_roots.h"
#include "scenefile/io/folder.h"
#include "scenefile/io/used_files.h"
#include "scenefile/verbs/load_scene.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// Which files a scene may open in addition to those in its own folders (docs/assets.md).
struct AssetAccess {
  std::vector<std::string> roots;  ///< additional folders, in order
  bool allow_outside = false;      ///< allow any file
};

/// A file that the scene or one of its meshes refers to, and where it was found.
struct AssetFile {
  AssetKind kind = AssetKind::texture;
  FileReference reference;
  std::string from;  ///< the mesh or material library that names it; empty: the scene
  ResolvedAsset resolved;
};

/// load_scene() for a file, or for standard input if the path is "-".
LoadedScene load_scene_file(const std::string& path, const LoadSettings& settings = {},
                            const AssetAccess& access = {});

/// The same for the text that a file at `path` has or is to have.
LoadedScene load_scene_text(const std::string& path, std::string text,
                            const LoadSettings& settings = {}, const AssetAccess& access = {});

/// The same for a scene that was changed or built in memory: loads scene.written as if it were
/// stored at scene.path, which need not exist.
void load_written_file(LoadedScene& scene, const LoadSettings& settings = {},
                       const AssetAccess& access = {});

/// The picture in the bytes of the file at `path`; `layer` as for decode_picture(). The error names
/// the file, and says so if it is a scene.
Result<DecodedPicture> decode_picture_file(std::string_view bytes, const std::string& path,
                                           std::string_view layer = {}, const Limits& limits = {});

/// The same, after reading it.
Result<DecodedPicture> load_picture_file(const std::string& path, std::string_view layer = {},
                                         const Limits& limits = {});

/// A fingerprint (base/hash.h) of the bytes of a file, or of the error if it cannot be read.
std::uint64_t file_fingerprint(const std::string& path, const Limits& limits = {});

/// The path of the table (realtime_table.h) in the folder of references or in its parent folder;
/// empty if there is none.
std::string settings_table(const std::string& folder);

/// Where the files of a scene at `path` may be: `access`, and the folder in the environment
/// variable CS123_DATA, which replaces /course/cs123/data of the course's machines.
AssetRootsOptions asset_roots_options(const std::string& path, const AssetAccess& access,
                                      const Limits& limits);

/// Where each file of the scene was found: its textures, its meshes, then the files that the loaded
/// meshes name.
std::vector<AssetFile> locate_files(const LoadedScene& scene, const AssetAccess& access,
                                    const Limits& limits);

/// The scene, its textures and meshes, and the files that its meshes name, used or not. No output
/// of the same work may replace them (used_files.h).
std::vector<UsedFile> used_files(const LoadedScene& scene, const AssetAccess& access,
                                 const Limits& limits);

/// Frees data that only messages about the file need (text, written scene, sources), before
/// memory-intensive work.
void forget_file(LoadedScene& scene);

}  // namespace scenefile
