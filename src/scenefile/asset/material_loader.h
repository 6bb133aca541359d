#pragma once
// Finds the materials of mesh faces in material libraries. Internal to asset.

#include "scenefile/asset/load_assets.h"
#include "scenefile/asset/mtl_file.h"
#include "scenefile/asset/read_obj.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace scenefile {

/// Reads the libraries of several meshes, each once. The rules are those of load_assets().
class MaterialLoader {
 public:
  /// `byte_budget` is what remains of limits.mesh_bytes. Everything outlives the loader.
  MaterialLoader(const FetchFile& fetch, const Limits& limits, std::uint64_t& byte_budget,
                 std::span<const FileReference> texture_files, Diagnostics& diagnostics);

  /// The materials of the mesh with this file name.
  MeshMaterials load(const std::string& mesh, const ObjMaterials& written);

  /// The libraries that were looked for.
  const std::vector<MeshReference>& libraries() const { return files_; }
  /// The maps of the materials, in the order of their indices, which follow those of the scene's
  /// textures.
  const std::vector<MeshReference>& maps() const { return maps_; }

 private:
  struct Library {
    std::string file;
    std::optional<Error> error;  // why it cannot be read
    std::vector<MtlMaterial> materials;
    std::unordered_map<std::string_view, std::size_t> numbers;  // of materials, by name
    std::vector<bool> judged;                                   // of materials
  };

  // The libraries that count for the mesh.
  std::vector<Library*> read_libraries(const std::string& mesh, const ObjMaterials& written);
  Library& read_library(const FileReference& file, const std::string& mesh);
  // False if no library defines it.
  bool add_material(const std::string& mesh, const FileReference& name,
                    const std::vector<Library*>& libraries, std::vector<FaceMaterial>& materials);
  void report_unknown(const std::string& mesh, const FileReference& name,
                      const std::vector<Library*>& libraries);
  FaceMaterial face_material(const std::string& mesh, const Library& library,
                             const MtlMaterial& written);
  std::uint32_t map_index(const std::string& mesh, const Library& library,
                          const FileReference& map);
  // Reports what may be drawn differently from what the author expects.
  void judge(const Library& library, const MtlMaterial& written, const FaceMaterial& m);
  void report(const Code& code, Location location, const std::string& file, std::string message,
              std::vector<std::string> notes = {});

  const FetchFile& fetch_;
  const Limits& limits_;
  std::uint64_t& budget_;
  Diagnostics& diagnostics_;
  std::size_t first_map_;
  std::unordered_map<std::string, Library> libraries_;
  std::unordered_map<std::string, std::uint32_t> textures_;
  std::vector<MeshReference> files_;
  std::vector<MeshReference> maps_;
};

}  // namespace scenefile
