#include "scenefile/format/read_scene.h"

#include "scenefile/format/codes.h"
#include "scenefile/format/dialects.h"
#include "scenefile/format/scene_text.h"

#include <algorithm>
#include <string>

namespace scenefile {

namespace {

Scene read(std::string_view bytes, const ReadOptions& options, Diagnostics& diagnostics) {
  std::string storage;
  const std::optional<SceneText> file = open_text(bytes, storage, diagnostics);
  if (!file) {
    return {};
  }
  return file->syntax == SceneFormat::xml ? read_xml(file->text, options, diagnostics)
                                          : read_json(file->text, options, diagnostics);
}

// Whether the code was reported after the first `before` findings.
bool has_since(std::size_t before, const Diagnostics& diagnostics, const Code& code) {
  const auto& list = diagnostics.list();
  return std::any_of(list.begin() + static_cast<std::ptrdiff_t>(before), list.end(),
                     [&](const Diagnostic& d) { return d.code == &code; });
}

}  // namespace

Scene read_scene(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.count(Severity::error);
  const std::size_t before = diagnostics.list().size();
  Scene scene = read(text, options, diagnostics);
  // Without a root nothing is drawn; it is enough to report that once.
  scene.incomplete = diagnostics.count(Severity::error) != errors ||
                     has_since(before, diagnostics, "xml.no-root"_code);
  return scene;
}

}  // namespace scenefile
