#include "app/command.h"
#include "app/output.h"
#include "app/program_folder.h"
#include "scenefile/base/text.h"
#include "scenefile/trace/trace_scene.h"
#include "scenefile/verbs/scene_json.h"

#include <fmt/format.h>

#include <string>

namespace scenefile::app {

ExitCode run_version(const Options& options, Context& context) {
  context.phase = "asking Embree for its version";
  const TraceBackend backend = trace_backend();
  const std::string embree = backend.embree.empty() ? "unknown" : backend.embree;
  const std::string documentation = documentation_folder();
  if (!options.json) {
    std::string text = fmt::format(
        "scenefile {}\n"
        "  build   {}, {}\n"
        "  Embree  {}\n"
        "  lanes   {}\n",
        SCENEFILE_VERSION, SCENEFILE_BUILD_TYPE, SCENEFILE_COMPILER, embree, backend.lanes);
    if (!documentation.empty()) {
      text += fmt::format("  docs    {}\n", escaped(documentation));
    }
    return answer(text);
  }
  Json json;
  begin_document(json, "version");
  json.add({{"build_type", SCENEFILE_BUILD_TYPE},
            {"compiler", SCENEFILE_COMPILER},
            {"embree", embree},
            {"lanes", backend.lanes}});
  if (!documentation.empty()) {
    json.add("docs", documentation);
  }
  json.end_object();
  return answer(json.text());
}

}  // namespace scenefile::app
