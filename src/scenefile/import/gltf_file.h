#pragma once
// A glTF file taken apart: its JSON, its bytes, its tables. Private to the room.

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
  std::string_view bytes;    ///< empty where the view is wrong
  std::uint64_t stride = 0;  ///< 0: packed
};

struct GltfFile {
  JsonTape tape;
  JsonValue root;
  std::vector<std::string> fetched;  ///< what `buffers` lie in, but for the file itself
  std::vector<std::string_view> buffers;
  std::vector<GltfView> views;
  std::vector<JsonValue> accessors;
  std::vector<JsonValue> materials;
  std::vector<JsonValue> textures;
  std::vector<JsonValue> images;
  std::vector<JsonValue> meshes;
  std::vector<JsonValue> nodes;
  std::vector<JsonValue> cameras;
  std::vector<JsonValue> lights;
};

/// Takes the file apart, which must outlive the result, and fetches its buffers. False when errors
/// were reported.
bool open_gltf(std::string_view bytes, const ImportOptions& options, GltfFile& file,
               Diagnostics& diagnostics);

/// The bytes of a `data:` URI, or of the file that it names. Nothing with the reason in `error`.
std::optional<std::string> fetch_uri(const std::string& uri, const ImportOptions& options,
                                     std::string& error);

}  // namespace scenefile
