#pragma once
// A parsed glTF file: its JSON, buffers, and tables. Internal to import.

#include "scenefile/base/diagnostics.h"
#include "scenefile/import/imported_scene.h"
#include "scenefile/import/json_value.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

inline constexpr std::uint32_t no_item = 0xffffffffu;

struct GltfView {
  std::string_view bytes;    ///< empty if the view is invalid
  std::uint64_t stride = 0;  ///< 0: packed
};

struct GltfFile {
  JsonTape tape;
  JsonValue root;
  std::vector<std::string> fetched;  ///< storage of `buffers`, except for those in the file itself
  std::vector<std::string_view> buffers;
  std::vector<GltfView> views;
  std::vector<JsonValue> accessors;
  std::vector<JsonValue> materials;
  std::vector<JsonValue> textures;
  std::vector<JsonValue> samplers;
  std::vector<JsonValue> images;
  std::vector<JsonValue> meshes;
  std::vector<JsonValue> nodes;
  std::vector<JsonValue> cameras;
  std::vector<JsonValue> lights;
};

/// Parses a file and fetches its buffers. `bytes` must outlive the result. Returns false if errors
/// were reported.
bool open_gltf(std::string_view bytes, const ImportOptions& options, GltfFile& file,
               Diagnostics& diagnostics);

/// The bytes of a `data:` URI, or of the file it names.
Result<std::string> fetch_uri(const std::string& uri, const ImportOptions& options);

}  // namespace scenefile
