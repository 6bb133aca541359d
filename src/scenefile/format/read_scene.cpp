#include "scenefile/format/read_scene.h"

#include "scenefile/format/json_reader.h"
#include "scenefile/format/syntax.h"
#include "scenefile/format/text_encoding.h"
#include "scenefile/format/xml_scene.h"

#include <string>

namespace scenefile {

namespace {

Scene read(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics) {
  std::string storage;
  const std::optional<std::string_view> decoded = decode_text(text, storage, diagnostics);
  if (!decoded) {
    return {};
  }
  const std::optional<SceneFormat> syntax = syntax_of(*decoded, diagnostics);
  if (!syntax) {
    return {};
  }
  return *syntax == SceneFormat::xml ? read_xml(*decoded, options, diagnostics)
                                     : read_json(*decoded, options, diagnostics);
}

}  // namespace

Scene read_scene(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.count(Severity::error);
  Scene scene = read(text, options, diagnostics);
  scene.incomplete = diagnostics.count(Severity::error) != errors;
  return scene;
}

}  // namespace scenefile
