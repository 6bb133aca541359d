#include "write_laws.h"

#include "finding_laws.h"
#include "law.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/format/write_scene.h"
#include "scenefile/scene/prepare.h"

#include <string>

namespace scenefile::fuzz {

namespace {

bool silent(const Diagnostics& diagnostics) {
  return diagnostics.count(Severity::error) + diagnostics.count(Severity::warning) == 0;
}

void require_rereadable_as(const Scene& scene, std::string_view source, SceneFormat format) {
  const Limits limits;
  Diagnostics written(limits);
  const std::string text = write_scene(scene, format, limits, written);
  require_sound(written, limits, source);
  if (written.has_errors()) {
    return;
  }
  Diagnostics reread(limits);
  const Scene read = read_scene(text, {}, reread);
  require(silent(reread), "what was written is read without a word");
  Diagnostics again(limits);
  require(write_scene(read, format, limits, again) == text, "writing twice is writing once");
  if (silent(written)) {
    require(same_meaning(scene, read), "writing keeps the meaning");
  }
}

}  // namespace

void require_rereadable(const Scene& scene, std::string_view source) {
  require_rereadable_as(scene, source, SceneFormat::xml);
  require_rereadable_as(scene, source, SceneFormat::json);
}

}  // namespace scenefile::fuzz
