// Feeds text to load_assets() as a mesh that is its own material library, with high and low limits.
// Files whose name ends in .tga are a picture.

#include "finding_laws.h"
#include "law.h"
#include "scenefile/asset/load_assets.h"
#include "target.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace {

using namespace scenefile;
using fuzz::require;

// An uncompressed TGA of 2x2 pixels.
constexpr std::string_view checker(
    "\0\0\2\0\0\0\0\0\0\0\0\0\2\0\2\0\x18\0\0\0\xff\0\xff\0\xff\0\0\xff\xff\xff", 30);

bool is_color(const glm::vec3& c) {
  return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z) && c.x >= 0 && c.y >= 0 &&
         c.z >= 0;
}

void require_valid(const FaceMaterial& m, std::size_t textures) {
  require(is_color(m.diffuse) && is_color(m.specular) && is_color(m.emission) &&
              is_color(m.transmission),
          "colors are finite and not negative");
  require(std::isfinite(m.shininess) && m.shininess >= 0, "Ns is finite and not negative");
  require(std::isfinite(m.ior) && m.ior > 0, "Ni is finite and above 0");
  for (const std::uint32_t map : {m.diffuse_map, m.specular_map, m.emission_map}) {
    require(map == no_map || map < textures, "maps are textures");
  }
  require(m.location.known(), "a material has a place");
}

void judge(const std::string& text, const Limits& limits) {
  Diagnostics diagnostics(limits);
  LoadOptions options;
  options.materials = true;
  options.limits = limits;
  const FetchFile fetch = [&](const std::string& name) {
    return name.ends_with(".tga") ? std::string(checker) : text;
  };
  const Assets assets =
      load_assets({}, std::vector<FileReference>{{"m/a.obj", {1, 1}}}, fetch, options, diagnostics);
  fuzz::require_sound(diagnostics, limits, text);
  const Mesh& mesh = assets.meshes.at(0);
  const MeshMaterials& materials = assets.mesh_materials.at(0);
  require(materials.of_triangle.empty() == materials.materials.empty(), "materials are used");
  require(materials.of_triangle.empty() || materials.of_triangle.size() == mesh.triangles.size(),
          "every triangle has an entry");
  for (const std::uint32_t material : materials.of_triangle) {
    require(material == mesh_no_index || material < materials.materials.size(), "materials exist");
  }
  for (const std::size_t triangles : triangles_of_materials(materials)) {
    require(triangles > 0, "each material has a triangle");
  }
  for (const FaceMaterial& m : materials.materials) {
    require_valid(m, assets.textures.size());
  }
  const auto maps =
      std::count_if(assets.mesh_references.begin(), assets.mesh_references.end(),
                    [](const MeshReference& r) { return r.kind == AssetKind::texture; });
  require(static_cast<std::size_t>(maps) == assets.textures.size(), "each map is a texture");
  require(materials.materials.size() * sizeof(FaceMaterial) <= limits.mesh_bytes,
          "materials are counted");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  judge(text, {});
  Limits narrow = fuzz::narrow_limits();
  narrow.mesh_triangles = 6;
  narrow.mesh_bytes = 3000;
  judge(text, narrow);
  return 0;
}
