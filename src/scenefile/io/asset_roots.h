#pragma once
// Where the files that a scene names may be found, and which may be opened.

#include "scenefile/io/file.h"

#include <cstdint>
#include <string>
#include <vector>

namespace scenefile {

/// How a name was found; rule numbers as in docs/assets.md.
enum class AssetRule : std::uint8_t {
  absolute,        ///< as written, inside a root
  scene_folder,    ///< beside the scene
  scene_parent,    ///< beside the scene's folder: image(s), texture(s), mesh(es), model(s) there
  current_folder,  ///< in the working directory, where that lies inside a root
  asset_root,      ///< under an --asset-root
  path_suffix,     ///< the end of the written path, in a root
  base_name,       ///< the bare file name, found once below the roots
  not_found,
};

struct AssetRootsOptions {
  std::string scene_path;                ///< "-" for standard input: no folder of its own
  std::vector<std::string> asset_roots;  ///< in this order
  bool allow_outside = false;            ///< open files outside the roots too
  std::uint64_t max_bytes = std::uint64_t{1} << 30;
};

struct ResolvedAsset {
  AssetRule rule = AssetRule::not_found;
  std::string path;                ///< the file, links resolved; empty when not found
  std::vector<std::string> tried;  ///< what was looked for, in order, for the message
  IoError error;                   ///< why it cannot be used; empty: found
};

/// Resolves a name as written in the scene. Nothing outside the roots is opened or named.
ResolvedAsset resolve_asset(const AssetRootsOptions& options, const std::string& name);

/// Resolves and reads. Only regular files; the check is made on what was opened.
IoError read_asset(const AssetRootsOptions& options, const std::string& name, std::string& bytes);

}  // namespace scenefile
