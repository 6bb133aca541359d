#include "scenefile/import/gltf_file.h"

#include "scenefile/base/base64.h"
#include "scenefile/base/text.h"
#include "scenefile/format/text_places.h"
#include "scenefile/import/codes.h"
#include "scenefile/import/read_gltf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <set>

namespace scenefile {

namespace {

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

struct Chunks {
  std::string_view json;
  std::string_view binary;
};

// Splits a GLB file into chunks; returns an error text if it is invalid. (Specification, section
// 4.4.)
std::string split(std::string_view bytes, Chunks& chunks) {
  constexpr std::size_t header = 12;
  constexpr std::size_t chunk_header = 8;
  if (bytes.size() < header + chunk_header) {
    return "the file ends within its header";
  }
  if (const std::uint32_t version = number_at(bytes, 4); version != 2) {
    return fmt::format("it is version {} of GLB, and only 2 is supported", version);
  }
  const std::uint32_t length = number_at(bytes, 8);
  if (length < header + chunk_header) {
    return fmt::format("its header says that it has {} bytes, fewer than the header", length);
  }
  if (length > bytes.size()) {
    return fmt::format("the file ends early: it should have {} bytes and has {}", length,
                       bytes.size());
  }
  bytes = bytes.substr(0, length);
  for (std::size_t at = header; bytes.size() - at >= chunk_header;) {
    const std::uint64_t size = number_at(bytes, at);
    const std::string_view kind = bytes.substr(at + 4, 4);
    at += chunk_header;
    if (size > bytes.size() - at) {
      return "a chunk reaches beyond the end of the file";
    }
    if (kind == "JSON" && chunks.json.empty()) {
      chunks.json = bytes.substr(at, size);
    } else if (kind == std::string_view("BIN\0", 4) && chunks.binary.empty()) {
      chunks.binary = bytes.substr(at, size);
    }
    at += std::min<std::size_t>((size + 3) / 4 * 4, bytes.size() - at);
  }
  return chunks.json.empty() ? "it has no JSON chunk" : "";
}

class Opener {
 public:
  Opener(const ImportOptions& options, GltfFile& file, Diagnostics& diagnostics)
      : options_(options), file_(file), diagnostics_(diagnostics) {}

  bool open(std::string_view bytes) {
    Chunks chunks{bytes, {}};
    if (is_glb(bytes)) {
      chunks.json = {};
      if (const std::string wrong = split(bytes, chunks); !wrong.empty()) {
        return fail("import.not-a-model"_code, {}, wrong);
      }
    }
    if (!parse(chunks.json, is_glb(bytes)) || !check_version() || !check_extensions()) {
      return false;
    }
    tables();
    return buffers(chunks.binary) && views();
  }

 private:
  bool fail(const Code& code, Location location, std::string message) {
    diagnostics_.report(code, location, std::move(message));
    return false;
  }

  bool parse(std::string_view text, bool binary) {
    text = without_byte_order_mark(text);
    const JsonError error = parse_json(text, options_.limits.nesting, file_.tape);
    if (error.fault == JsonFault::too_deep) {
      return fail("import.limit"_code, {},
                  fmt::format("the JSON is nested deeper than {} levels", options_.limits.nesting));
    }
    if (error.fault != JsonFault::none || !file_.tape.is_object(0)) {
      const std::size_t at = error.fault == JsonFault::none ? 0 : error.offset;
      return binary ? fail("import.not-a-model"_code, {},
                           fmt::format("its JSON is damaged at byte {} of the chunk", at))
                    : fail("import.not-a-model"_code, TextPlaces(text).at(at),
                           "this is not the JSON of a glTF file");
    }
    file_.root = JsonValue(file_.tape, 0);
    return true;
  }

  bool check_version() {
    const std::string version = file_.root["asset"]["version"].string().value_or("");
    if (version.empty()) {
      return fail("import.not-a-model"_code, {},
                  "asset.version is missing: this is not a glTF file");
    }
    return version.starts_with("2.") ||
           fail("import.unsupported"_code, {},
                fmt::format("it is glTF {}; export it as glTF 2.0", quoted(version)));
  }

  std::set<std::string> unknown_extensions(std::string_view list) const {
    constexpr std::string_view known[] = {
        "KHR_lights_punctual",        "KHR_materials_emissive_strength",
        "KHR_materials_ior",          "KHR_materials_specular",
        "KHR_materials_transmission", "KHR_materials_volume",
        "KHR_mesh_quantization",      "KHR_texture_transform"};
    std::set<std::string> unknown;
    for (const JsonValue& extension : file_.root[list].elements()) {
      std::string name = extension.string().value_or("");
      if (std::find(std::begin(known), std::end(known), name) == std::end(known)) {
        unknown.insert(std::move(name));
      }
    }
    return unknown;
  }

  // A required extension changes the meaning of the data; others can be left out.
  bool check_extensions() {
    const std::set<std::string> required = unknown_extensions("extensionsRequired");
    for (const std::string& name : required) {
      fail("import.unsupported"_code, {},
           fmt::format("the file requires the extension {}; export it without", quoted(name)));
    }
    for (const std::string& name : unknown_extensions("extensionsUsed")) {
      if (!required.contains(name)) {
        diagnostics_.report("import.left-out"_code, {},
                            fmt::format("what the extension {} adds is left out", quoted(name)));
      }
    }
    return required.empty();
  }

  void tables() {
    const JsonValue& root = file_.root;
    file_.accessors = root["accessors"].elements();
    file_.materials = root["materials"].elements();
    file_.textures = root["textures"].elements();
    file_.samplers = root["samplers"].elements();
    file_.images = root["images"].elements();
    file_.meshes = root["meshes"].elements();
    file_.nodes = root["nodes"].elements();
    file_.cameras = root["cameras"].elements();
    file_.lights = root["extensions"]["KHR_lights_punctual"]["lights"].elements();
  }

  bool buffers(std::string_view binary) {
    bool fine = true;
    std::uint64_t total = 0;
    const std::vector<JsonValue> list = file_.root["buffers"].elements();
    file_.fetched.reserve(list.size());  // views into short strings must not move
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::optional<std::string> uri = list[i]["uri"].string();
      std::string_view bytes = binary;
      if (uri) {
        Result<std::string> fetched = fetch_uri(*uri, options_);
        if (!fetched) {
          diagnostics_.report("import.missing-file"_code, Severity::error, {},
                              fmt::format("buffers[{}]: {}", i, fetched.error().text));
          return false;
        }
        total += fetched->size();
        if (total > options_.limits.mesh_bytes) {
          return fail("import.limit"_code, {},
                      "the buffers are larger than the limit for all meshes");
        }
        file_.fetched.push_back(*std::move(fetched));
        bytes = file_.fetched.back();
      }
      const std::optional<std::uint64_t> size = list[i]["byteLength"].whole();
      if (!size || *size > bytes.size()) {
        fine = fail("import.value"_code, {},
                    fmt::format("buffers[{}].byteLength is missing or more than the {} bytes "
                                "there are",
                                i, bytes.size()));
      }
      file_.buffers.push_back(bytes.substr(0, size.value_or(0)));
    }
    return fine;
  }

  bool views() {
    bool fine = true;
    const std::vector<JsonValue> list = file_.root["bufferViews"].elements();
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::uint64_t buffer = list[i]["buffer"].whole().value_or(no_item);
      const std::uint64_t offset =
          list[i]["byteOffset"] ? list[i]["byteOffset"].whole().value_or(~std::uint64_t{0}) : 0;
      const std::uint64_t length = list[i]["byteLength"].whole().value_or(~std::uint64_t{0});
      const std::uint64_t stride = list[i]["byteStride"].whole().value_or(0);
      GltfView view;
      if (buffer < file_.buffers.size() && offset <= file_.buffers[buffer].size() &&
          length <= file_.buffers[buffer].size() - offset && stride <= 252) {
        view = {file_.buffers[buffer].substr(offset, length), stride};
      } else {
        fine = fail("import.value"_code, {},
                    fmt::format("bufferViews[{}] reaches beyond its buffer", i));
      }
      file_.views.push_back(view);
    }
    return fine;
  }

  const ImportOptions& options_;
  GltfFile& file_;
  Diagnostics& diagnostics_;
};

int hex_digit(char c) {
  return c >= '0' && c <= '9'   ? c - '0'
         : c >= 'a' && c <= 'f' ? c - 'a' + 10
         : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                : -1;
}

std::string percent_decoded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && hex_digit(text[i + 1]) >= 0 &&
        hex_digit(text[i + 2]) >= 0) {
      result += static_cast<char>(hex_digit(text[i + 1]) * 16 + hex_digit(text[i + 2]));
      i += 2;
    } else {
      result += text[i];
    }
  }
  return result;
}

}  // namespace

bool is_glb(std::string_view bytes) {
  return bytes.starts_with("glTF");
}

bool open_gltf(std::string_view bytes, const ImportOptions& options, GltfFile& file,
               Diagnostics& diagnostics) {
  return Opener(options, file, diagnostics).open(bytes);
}

Result<std::string> fetch_uri(const std::string& uri, const ImportOptions& options) {
  if (uri.starts_with("data:")) {
    const std::size_t comma = uri.find(',');
    std::optional<std::string> bytes;
    if (comma != std::string::npos && std::string_view(uri).substr(0, comma).ends_with(";base64")) {
      bytes = base64_decoded(std::string_view(uri).substr(comma + 1));
    }
    return bytes ? Result<std::string>(*std::move(bytes))
                 : input_error("its data URI is not base64");
  }
  const std::string name = percent_decoded(uri);
  return options.fetch ? options.fetch(name)
                       : Error{fmt::format("the file {} is not opened here", quoted(name, 400))};
}

}  // namespace scenefile
