#pragma once
// Where to look for the files that a scene names, and which may be opened. The rules for users are
// in docs/assets.md.

#include "scenefile/io/file.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// How a file was found, in the order in which the rules are tried.
enum class AssetRule : std::uint8_t {
  absolute,      ///< as written, inside a root
  scene_folder,  ///< next to the scene
  scene_parent,  ///< next to the scene's folder: image(s), texture(s), mesh(es), model(s)
  asset_root,    ///< under an --asset-root
  path_suffix,   ///< the end of the written path, in a root
  base_name,     ///< the base name, below the roots
  not_found,
};

/// For messages, such as "next to the scene".
std::string_view rule_text(AssetRule rule);

struct AssetRootsOptions {
  std::string scene_path;                ///< "-" for standard input, which has no folder
  std::vector<std::string> asset_roots;  ///< in order of priority
  bool allow_outside = false;            ///< also open files outside the roots
  std::uint64_t max_bytes = std::uint64_t{1} << 30;
};

struct ResolvedAsset {
  AssetRule rule = AssetRule::not_found;
  std::string path;                ///< the file, with links resolved; empty if not found
  std::vector<std::string> tried;  ///< candidates in order, without duplicates
  std::string error;               ///< why it cannot be used, in one line; empty if found
  std::vector<std::string> notes;  ///< about the error: places searched, as seen from the scene
};

class AssetIndex;

/// The folders whose files a scene may use: its own folder; next to that, the folders image,
/// images, texture, textures, mesh, meshes, model and models; and each asset root. Links are
/// resolved before a path is checked.
class AssetRoots {
 public:
  explicit AssetRoots(AssetRootsOptions options);
  ~AssetRoots();

  /// Resolves a name as written in the scene. Opens nothing outside the roots.
  ResolvedAsset resolve(const std::string& name);

  /// Where the name was found, relative to the working directory if the scene's path is; empty: not
  /// found.
  std::string path_of(const std::string& name);

  /// Resolves a name and reads the file. Only regular files; the check is made on the opened file.
  Result<std::string> read(const std::string& name);

 private:
  friend class AssetSearch;

  bool contains(std::string_view canonical_path) const;
  const AssetIndex& index();

  AssetRootsOptions options_;
  std::string scene_folder_;  ///< empty for standard input, or if it does not exist
  std::string scene_parent_;
  std::vector<std::string> given_;      ///< the asset roots that exist
  std::vector<std::string> allowed_;    ///< all roots
  std::unique_ptr<AssetIndex> index_;   ///< for searches by base name, built at the first one
  std::size_t suggestions_left_ = 100;  ///< each compares a name with all files
};

}  // namespace scenefile
