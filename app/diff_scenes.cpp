#include "app/diff.h"
#include "app/load.h"
#include "app/output.h"
#include "scenefile/verbs/compare_scenes.h"

namespace scenefile::app {

namespace {

LoadedScene load(const std::string& path, const Options& options, Context& context) {
  LoadedScene scene = load_scene(path, options, LoadDepth::prepared, true, context);
  if (!options.json) {
    say(findings_text(scene, options.quiet ? Verbosity::errors : Verbosity::warnings,
                      wants_color(Stream::chatter)));
  }
  return scene;
}

}  // namespace

ExitCode diff_scenes(const Options& options, Context& context) {
  const LoadedScene a = load(options.arguments[0], options, context);
  const LoadedScene b = load(options.arguments[1], options, context);
  const ExitCode status = worse(status_of(a), status_of(b));
  if (status != ExitCode::fine) {
    return options.json ? worse(status, answer(compare_scenes_json(a, b, nullptr))) : status;
  }
  context.phase = "comparing the scenes";
  const SceneDiff diff = compare_scenes(a, b);
  const ExitCode found = diff.same_meaning ? ExitCode::fine : ExitCode::findings;
  if (options.json) {
    return worse(found, answer(compare_scenes_json(a, b, &diff)));
  }
  return options.quiet ? found : worse(found, answer(compare_scenes_text(a, b, diff)));
}

}  // namespace scenefile::app
