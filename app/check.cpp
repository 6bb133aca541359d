#include "app/command.h"
#include "app/findings.h"
#include "app/json.h"
#include "app/load.h"
#include "app/output.h"

#include <string>
#include <vector>

namespace scenefile::app {

ExitCode run_check(const Options& options, Context& context) {
  const LoadDepth depth = options.assets ? LoadDepth::with_all_assets : LoadDepth::checked;
  ExitCode status = ExitCode::fine;
  std::vector<std::string> report;
  for (const std::string& path : options.arguments) {
    LoadedScene scene = load_scene(path, options, depth, options.allow_missing, context);
    apply_policy(options, scene.diagnostics);
    status = worse(status, status_of(scene));
    context.phase = "writing the report";
    if (options.json) {
      report.push_back(scene_json(scene));
      continue;
    }
    const std::string text = findings_text(
        scene, options.quiet ? Verbosity::errors : Verbosity::all, wants_color(Stream::answer));
    if (!scene.unreadable.empty()) {
      say(text);
    } else if (answer(text) != ExitCode::fine) {
      return ExitCode::environment;
    }
  }
  return options.json ? worse(status, answer(check_json(report))) : status;
}

}  // namespace scenefile::app
