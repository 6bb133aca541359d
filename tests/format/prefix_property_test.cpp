// A file truncated anywhere is never accepted as complete.

#include "format/reading.h"
#include "format/write_random_scene.h"
#include "scenefile/edit/format_text.h"
#include "scenefile/format/write_scene.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace scenefile::testing {
namespace {

RC_GTEST_PROP(PrefixLaws, EveryPrefixEndsWithAnError, ()) {
  const Scene scene = RandomScene(*rc::gen::arbitrary<unsigned>(), 3, true).make();
  for (const SceneFormat format : {SceneFormat::xml, SceneFormat::json}) {
    Diagnostics diagnostics;
    const std::string text = write_scene(scene, format, {}, diagnostics);
    RC_PRE(!diagnostics.has_errors());
    const auto end = text.find_last_of(">}");
    for (int i = 0; i < 50; ++i) {
      const std::string prefix = text.substr(0, *rc::gen::inRange<std::size_t>(0, end));
      RC_ASSERT(read(prefix).diagnostics.has_errors());
      RC_ASSERT(read_compat(prefix).diagnostics.has_errors());
      Diagnostics of_layout;
      RC_ASSERT(!lay_out(prefix, {}, of_layout).has_value());
      RC_ASSERT(of_layout.has_errors());
    }
  }
}

}  // namespace
}  // namespace scenefile::testing
