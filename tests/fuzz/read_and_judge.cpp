#include "read_and_judge.h"

#include "finding_laws.h"
#include "law.h"
#include "scene_laws.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/scene/check.h"
#include "scenefile/scene/codes.h"
#include "scenefile/scene/summary.h"
#include "write_laws.h"

#include <algorithm>

namespace scenefile::fuzz {

namespace {

// Findings that only programs that edit scenes can cause, but no text.
void require_well_built(const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    require(diagnostic.code != &"scene.bad-index"_code &&
                diagnostic.code != &"scene.shared-node"_code &&
                diagnostic.code != &"scene.not-finite"_code,
            "the reader builds a forest of finite values");
  }
}

void require_ready(const Scene& scene, const Limits& limits) {
  const Prepared prepared = prepare(scene, limits);
  require_valid(prepared, limits);
  require(prepare(scene, limits).scene == prepared.scene, "preparing is a function");
  require(same_meaning(scene, scene), "a scene does not differ from itself");
  // At most, up to rounding: the render scene leaves out objects that are not invertible.
  require(
      count_virtual_primitives(prepared.scene) <= summarize(scene).virtual_primitives * 1.000001,
      "the ready scene holds no more than the written one");
}

void judge(std::string_view text, const ReadOptions& options) {
  Diagnostics diagnostics(options.limits);
  const Scene scene = read_scene(text, options, diagnostics);
  require_sound(diagnostics, options.limits, text);
  Diagnostics again(options.limits);
  const Scene same = read_scene(text, options, again);
  require(again.list().size() == diagnostics.list().size(), "reading is a function");
  // NaN, for numbers that could not be read, is not equal to itself.
  const bool no_root = std::any_of(
      diagnostics.list().begin(), diagnostics.list().end(),
      [](const Diagnostic& diagnostic) { return diagnostic.code == &"xml.no-root"_code; });
  require(scene.incomplete == (diagnostics.has_errors() || no_root),
          "a scene of a file with errors, or without a root, says so");
  require(scene.incomplete || scene == same, "reading gives the same finite values each time");
  check(scene, options.limits, diagnostics);
  require_sound(diagnostics, options.limits, text);
  require_well_built(diagnostics);
  if (diagnostics.has_errors()) {
    require_safe(prepare(scene, options.limits), options.limits);
  } else {
    require_ready(scene, options.limits);
    require_rereadable(scene, text);
  }
}

}  // namespace

void read_and_judge(std::string_view text) {
  judge(text, {});
  judge(text, {.compat_course = true, .limits = narrow_limits()});
}

}  // namespace scenefile::fuzz
