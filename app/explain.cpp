#include "app/command.h"
#include "app/explain_report.h"
#include "app/findings.h"
#include "app/output.h"
#include "app/tracing.h"

#include <fmt/format.h>

namespace scenefile::app {

namespace {

Outcome explain(const Options& options, const RenderOptions& render, const LoadedScene& scene,
                ExplainReport& report, Context& context) {
  context.phase = "tracing";
  const Explainer explainer(scene.ready.scene, scene.assets, render);
  Outcome outcome = judge(explainer.status(), context);
  if (!outcome.error.empty()) {
    return outcome;
  }
  report.pixel = explainer.explain(options.pixel->x, options.pixel->y, options.sample);
  outcome = judge(explainer.status(), context);
  const std::size_t taken = report.pixel.samples.size();
  if (outcome.error.empty() && options.sample.value_or(0) >= taken) {
    return {ExitCode::usage, fmt::format("there is no sample {}: the pixel has {}, counted from 0",
                                         *options.sample, taken)};
  }
  report.remarks = remarks(scene.ready.scene, report.pixel);
  return outcome;
}

}  // namespace

ExitCode run_explain(const Options& options, Context& context) {
  const RenderOptions render = options.render;
  const LoadedScene scene = load_for_tracing(options, render, context);
  Outcome outcome{status_of(scene), "the scene cannot be used"};
  if (!options.json) {
    say(findings_text(scene, options.quiet ? Verbosity::errors : Verbosity::warnings,
                      wants_color(Stream::chatter)));
  }
  ExplainReport report;
  if (outcome.status == ExitCode::fine) {
    outcome = explain(options, render, scene, report, context);
    if (!options.json && !outcome.error.empty()) {
      say_error(outcome.error);
    }
  }
  if (options.json) {
    const ExplainReport* const found = outcome.error.empty() ? &report : nullptr;
    return worse(outcome.status, answer(explain_json(scene, render, found, outcome.error)));
  }
  if (outcome.status != ExitCode::fine) {
    return outcome.status;
  }
  const ExplainStyle style{wants_color(Stream::answer), wants_swatches(Stream::answer)};
  return answer(explain_text(scene, report, style));
}

}  // namespace scenefile::app
