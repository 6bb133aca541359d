#pragma once
// Materials and pictures of a glTF file. Internal to import.

#include "scenefile/base/diagnostics.h"
#include "scenefile/import/gltf_file.h"
#include "scenefile/scene/scene.h"

#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace scenefile {

/// A material, and the uvs it needs. In the format, uvs belong to the mesh, so the texture's set
/// and its transform (offset, rotation, scale) are applied there.
struct GltfMaterial {
  Material material;
  std::uint32_t uv_set = 0;
  glm::mat3x2 uv_map{1, 0, 0, 1, 0, 0};  ///< columns: images of u and v, offset; v points down
  bool repeats = true;  ///< the texture repeats outside of 0 to 1; otherwise it has no equivalent
};

class GltfMaterials {
 public:
  /// Adds pictures to `files`.
  GltfMaterials(const GltfFile& file, const ImportOptions& options,
                std::vector<ImportedFile>& files, Diagnostics& diagnostics);

  /// no_item: the specification's default material.
  const GltfMaterial& get(std::uint32_t index);

 private:
  GltfMaterial make(const JsonValue& json);
  void add_texture(const JsonValue& info, const glm::vec3& factor, GltfMaterial& result);
  std::string picture(std::uint32_t image, const glm::vec3& factor);
  void leave_out(std::string_view what);

  const GltfFile& file_;
  const ImportOptions& options_;
  std::vector<ImportedFile>& files_;
  Diagnostics& diagnostics_;
  std::map<std::uint32_t, GltfMaterial> known_;
  std::map<std::tuple<std::uint32_t, float, float, float>, std::string> pictures_;
  std::set<std::string, std::less<>> left_out_;
  std::uint64_t texture_budget_;
};

}  // namespace scenefile
