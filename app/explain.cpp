#include "scenefile/verbs/explain.h"

#include "app/command.h"
#include "app/load.h"
#include "app/output.h"

namespace scenefile::app {

ExitCode run_explain(const Options& options, Context& context) {
  const LoadedScene scene = load_for_tracing(options, context);
  if (!options.json) {
    say(findings_text(scene, options.quiet ? Verbosity::errors : Verbosity::warnings,
                      wants_color(Stream::chatter)));
  }
  if (const ExitCode status = status_of(scene); status != ExitCode::fine) {
    return options.json ? worse(status, answer(explain_json(scene, options.render, nullptr,
                                                            "the scene cannot be used")))
                        : status;
  }
  context.phase = "tracing";
  const Result<ExplainReport> report =
      explain_pixel(scene, options.render, options.pixel->x, options.pixel->y, options.sample);
  if (!report) {
    const Outcome outcome = judge(report.error(), context);
    if (options.json) {
      return worse(outcome.status,
                   answer(explain_json(scene, options.render, nullptr, outcome.error)));
    }
    say_error(outcome.error);
    return outcome.status;
  }
  if (options.json) {
    return answer(explain_json(scene, options.render, &*report));
  }
  const ExplainStyle style{wants_color(Stream::answer), wants_swatches(Stream::answer)};
  return answer(explain_text(scene, *report, style));
}

}  // namespace scenefile::app
