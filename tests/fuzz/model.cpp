// Feeds bytes to SCENEFILE_FUZZ_READER, read_gltf() or read_obj_scene(), with high and low limits.
// Files that they refer to are a picture if their name says so, and otherwise have the same bytes:
// an OBJ file is its own material library.

#include "finding_laws.h"
#include "law.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/asset/read_obj.h"
#include "scenefile/import/read_gltf.h"
#include "scenefile/import/read_obj_scene.h"
#include "scenefile/scene/check.h"
#include "target.h"

#include <set>
#include <string>
#include <string_view>

namespace {

using namespace scenefile;
using fuzz::require;

// The files that the scene refers to exist and can be read.
void require_files(const ImportedScene& imported) {
  std::set<std::string> names;
  for (const ImportedFile& file : imported.files) {
    require(names.insert(file.name).second, "file names are unique");
    require(file.name.starts_with("model-") && file.name.find('/') == std::string::npos,
            "names are ours");
    if (file.name.ends_with(".obj")) {
      const Limits limits;
      Diagnostics diagnostics(limits);
      std::uint64_t triangles = limits.mesh_triangles;
      std::uint64_t bytes = limits.mesh_bytes;
      read_obj(file.bytes, file.name, limits, triangles, bytes, diagnostics);
      require(!diagnostics.has_errors(), "meshes can be read");
    }
  }
  for (const Node& node : imported.scene.nodes) {
    for (const Primitive& primitive : node.primitives) {
      require(names.contains(primitive.mesh_file), "the mesh is there");
      require(!primitive.material.texture || names.contains(primitive.material.texture->file),
              "the texture is there");
    }
  }
}

Result<std::string> fetched(const std::string& name, std::string_view bytes) {
  static const std::string picture =
      *encode_image(Image(2, 1), ImageFormat::png8, Rounding::nearest);
  return name.ends_with(".png") ? picture : std::string(bytes);
}

void judge(std::string_view bytes, const Limits& limits) {
  Diagnostics diagnostics(limits);
  ImportOptions options;
  options.limits = limits;
  options.fetch = [&](const std::string& name) { return fetched(name, bytes); };
  const ImportedScene imported = SCENEFILE_FUZZ_READER(bytes, options, diagnostics);
  if (!diagnostics.has_errors()) {
    require_files(imported);
    check(imported.scene, limits, diagnostics);
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  Limits narrow = fuzz::narrow_limits();
  narrow.mesh_triangles = 6;
  narrow.mesh_bytes = 2000;
  judge(bytes, {});
  judge(bytes, narrow);
  return 0;
}
