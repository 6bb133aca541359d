#include "app/diff.h"
#include "app/findings.h"
#include "app/json.h"
#include "app/load.h"
#include "app/output.h"
#include "scenefile/base/text.h"
#include "scenefile/scene/diff.h"

#include <fmt/format.h>

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

// "chess.xml:41:9: ", or nothing.
std::string place_text(const std::string& path, Location location) {
  return location.known() ? fmt::format("{}:{}:{}: ", escaped(shown_name(path), 4096),
                                        location.line, location.column)
                          : std::string();
}

std::string verdict_text(const std::string& a, const std::string& b, const SceneDiff& diff) {
  const std::string both =
      fmt::format("{} and {}", escaped(shown_name(a), 4096), escaped(shown_name(b), 4096));
  const std::size_t count = diff.differences.size();
  if (diff.same_meaning) {
    return both + (diff.equal ? ": no difference\n" : ": same meaning, written differently\n");
  }
  return fmt::format("{}: {} difference{}\n", both, count, count == 1 ? "" : "s");
}

std::string answer_text(const LoadedScene& a, const LoadedScene& b, const SceneDiff& diff) {
  std::string text;
  for (const SceneDifference& difference : diff.differences) {
    text += place_text(a.path, difference.in_a) + place_text(b.path, difference.in_b) +
            difference_text(difference) + "\n";
  }
  return text + verdict_text(a.path, b.path, diff);
}

}  // namespace

ExitCode diff_scenes(const Options& options, Context& context) {
  const LoadedScene a = load(options.arguments[0], options, context);
  const LoadedScene b = load(options.arguments[1], options, context);
  const ExitCode status = worse(status_of(a), status_of(b));
  if (status != ExitCode::fine) {
    return options.json ? worse(status, answer(diff_json(a, b, nullptr))) : status;
  }
  context.phase = "comparing the scenes";
  const SceneDiff diff = diff_meaning(a.written, b.written);
  const ExitCode found = diff.same_meaning ? ExitCode::fine : ExitCode::findings;
  if (options.json) {
    return worse(found, answer(diff_json(a, b, &diff)));
  }
  return options.quiet ? found : worse(found, answer(answer_text(a, b, diff)));
}

}  // namespace scenefile::app
