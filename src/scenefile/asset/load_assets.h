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
#include <string_view>
#include <vector>

namespace scenefile {

enum class AssetKind : std::uint8_t { texture, mesh, library };

/// "texture", "mesh", or "library" for a material library.
constexpr std::string_view word_of(AssetKind kind) {
  return kind == AssetKind::texture ? "texture" : kind == AssetKind::mesh ? "mesh" : "library";
}

/// A file that a mesh names: a material library, or a texture of one of its materials.
struct MeshReference {
  AssetKind kind = AssetKind::library;
  FileReference file;  ///< by its name relative to the scene; its place is in `from`
  std::string from;    ///< the mesh or library that names it
};

/// The contents of a scene's files, at the same indices as RenderScene::texture_files and
/// mesh_files.
struct Assets {
  /// empty() if the file could not be used. After the scene's textures come those that face
  /// materials name.
  std::vector<Texture> textures;
  std::vector<Mesh> meshes;  ///< without triangles if the file could not be used
  /// As meshes; empty if LoadOptions::materials was not set.
  std::vector<MeshMaterials> mesh_materials;
  /// Each file once, also missing ones; empty if LoadOptions::materials was not set.
  std::vector<MeshReference> mesh_references;
};

/// Whether a mesh has a face that emits light.
bool has_emissive_faces(const Assets& assets);

/// Reads a file by its name as written in the scene; ErrorKind::limit means that it is larger than
/// allowed. The caller decides how names are resolved
/// and what may be opened (io/asset_roots.h has the rules of the format). With an empty function
/// every file counts as missing.
using FetchFile = std::function<Result<std::string>(const std::string& name)>;

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
///
/// Materials of faces: the names after mtllib and the maps of the materials are relative to the
/// folder of the mesh. Of each mtllib line the first library that can be read counts, and of each
/// material name the first definition. A face whose material is not found has that of its object,
/// with a warning. A color without a value is 0, or 1 if it has a map.
Assets load_assets(std::span<const FileReference> texture_files,
                   std::span<const FileReference> mesh_files, const FetchFile& fetch,
                   const LoadOptions& options, Diagnostics& diagnostics);

/// The libraries that a mesh names and their maps, without reading the mesh: for a command that
/// does not use materials but must not replace their files. `obj` is the text of `mesh`.
std::vector<MeshReference> files_named_by_mesh(const std::string& mesh, std::string_view obj,
                                               const FetchFile& fetch, const Limits& limits);

}  // namespace scenefile
