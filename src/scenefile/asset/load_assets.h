#pragma once
// From file names to images and meshes.

#include "scenefile/asset/face_material.h"
#include "scenefile/asset/image.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/base/location.h"
#include "scenefile/base/result.h"
#include "scenefile/geometry/mesh.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace scenefile {

/// The contents of a scene's files, at the same indices as RenderScene::texture_files and
/// mesh_files.
struct Assets {
  /// empty() if the file could not be used. After the scene's textures come those that face
  /// materials name.
  std::vector<Texture> textures;
  std::vector<Mesh> meshes;  ///< without triangles if the file could not be used
  /// As meshes; empty if LoadOptions::materials was not set.
  std::vector<MeshMaterials> mesh_materials;
};

/// Reads a file by its name as written in the scene; ErrorKind::limit means that it is larger than
/// allowed. The caller decides how names are resolved
/// and what may be opened (io/asset_roots.h has the rules of the format). With an empty function
/// every file counts as missing.
using FetchFile = std::function<Result<std::string>(const std::string& name)>;

enum class AssetKind : std::uint8_t { texture, mesh };

/// Calls work(0) to work(count - 1), each once, in any order, possibly in parallel;
/// returns when all are done.
using ForEach =
    std::function<void(std::size_t count, const std::function<void(std::size_t)>& work)>;

struct LoadOptions {
  bool textures = true;        ///< false: leave them all empty, without a diagnostic
  bool allow_missing = false;  ///< a mesh that cannot be used is a warning
  bool materials = false;      ///< also read the materials of mesh faces
  Limits limits;
  ForEach for_each = {};  ///< for decoding textures; empty: sequentially
};

/// Loads every file of the lists once, in their order. A texture that cannot be used is a warning
/// (it shades with the diffuse color), a mesh an error; their place is that of the reference.
/// Findings inside a mesh file carry its name and line. The limits on textures and meshes apply to
/// all of them together. Files are fetched sequentially; `for_each` does not change results
/// or findings. Codes: asset/codes.h.
Assets load_assets(std::span<const FileReference> texture_files,
                   std::span<const FileReference> mesh_files, const FetchFile& fetch,
                   const LoadOptions& options, Diagnostics& diagnostics);

}  // namespace scenefile
