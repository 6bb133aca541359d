#pragma once
// Where the files that a scene names may be found, and which may be opened. docs/assets.md has the
// rules for users.

#include "scenefile/io/file.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// How a name was found, in the order in which the rules are tried.
enum class AssetRule : std::uint8_t {
  absolute,        ///< as written, inside a root
  scene_folder,    ///< beside the scene
  scene_parent,    ///< beside the scene's folder: image(s), texture(s), mesh(es), model(s) there
  current_folder,  ///< in the working directory, where that lies inside a root
  asset_root,      ///< under an --asset-root
  path_suffix,     ///< the end of the written path, in a root; at last in any mixture of case
  base_name,       ///< the bare file name, found once below the roots
  not_found,
};

/// Such as "beside the scene".
std::string_view rule_text(AssetRule rule);

struct AssetRootsOptions {
  std::string scene_path;                ///< "-" for standard input: no folder of its own
  std::vector<std::string> asset_roots;  ///< in this order
  bool allow_outside = false;            ///< open files outside the roots too
  std::uint64_t max_bytes = std::uint64_t{1} << 30;
};

struct ResolvedAsset {
  AssetRule rule = AssetRule::not_found;
  std::string path;                ///< the file, links resolved; empty when not found
  std::vector<std::string> tried;  ///< what was looked for, in order, each once
  IoError error;                   ///< why it cannot be used; empty: found
};

class AssetIndex;

/// The folders of a scene whose files may be opened: its own, of its parent the folders image,
/// images, texture, textures, mesh, meshes, model and models, and each asset root. Links are
/// resolved before a path is judged.
class AssetRoots {
 public:
  explicit AssetRoots(AssetRootsOptions options);
  ~AssetRoots();

  /// Resolves a name as written in the scene. Nothing outside the roots is opened.
  ResolvedAsset resolve(const std::string& name);

  /// Resolves and reads. Only regular files; the check is made on what was opened.
  IoError read(const std::string& name, std::string& bytes);

 private:
  friend class AssetSearch;

  bool contains(std::string_view canonical_path) const;
  const AssetIndex& index();

  AssetRootsOptions options_;
  std::string scene_folder_;  ///< empty for standard input, and where there is none
  std::string scene_parent_;
  std::vector<std::string> given_;     ///< the asset roots that exist
  std::vector<std::string> allowed_;   ///< all roots
  std::unique_ptr<AssetIndex> index_;  ///< of the first search by base name; one for all names
};

}  // namespace scenefile
