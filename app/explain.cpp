#include "scenefile/verbs/explain.h"

#include "app/command.h"
#include "app/load.h"
#include "app/load_picture.h"
#include "app/output.h"
#include "app/realtime.h"
#include "scenefile/base/text.h"

#include <fmt/format.h>

namespace scenefile::app {

namespace {

// If no size is given, the picture of --mine determines it. Returns an error message.
ExitCode load_mine(Options& options, LoadedPicture& mine, Context& context) {
  if (options.mine.empty()) {
    return ExitCode::fine;
  }
  mine = load_picture({options.mine}, options.layer, context);
  if (!mine.error.empty()) {
    say_error(mine.error);
    return mine.status;
  }
  const Texture& picture = mine.picture.texture;
  if (!was_given(options, "--size")) {
    options.render.width = picture.width;
    options.render.height = picture.height;
  } else if (options.render.width != picture.width || options.render.height != picture.height) {
    say_error(fmt::format("{} is {}x{}, and --size says {}x{}", quoted(options.mine, 400),
                          picture.width, picture.height, options.render.width,
                          options.render.height));
    return ExitCode::usage;
  }
  if (options.pixel->x >= picture.width || options.pixel->y >= picture.height) {
    say_error(fmt::format("--pixel: {},{} is not in the picture: 0,0 to {},{}", options.pixel->x,
                          options.pixel->y, picture.width - 1, picture.height - 1));
    return ExitCode::usage;
  }
  return ExitCode::fine;
}

}  // namespace

ExitCode run_explain(const Options& given, Context& context) {
  Options options = given;
  LoadedPicture mine;
  if (const ExitCode status = load_mine(options, mine, context); status != ExitCode::fine) {
    return status;
  }
  LoadedScene scene = load_for_tracing(options, context);
  const std::optional<RealtimeOptions> realtime = realtime_options(options);
  if (realtime && status_of(scene) == ExitCode::fine) {
    check_realtime(*realtime, scene);
  }
  if (!options.json) {
    say(findings_text(scene, options.quiet ? Verbosity::errors : Verbosity::warnings,
                      wants_color(Stream::chatter)));
  }
  if (const ExitCode status = status_of(scene); status != ExitCode::fine) {
    return options.json ? worse(status, answer(explain_json(scene, options.render, nullptr,
                                                            "the scene cannot be used", realtime)))
                        : status;
  }
  context.phase = "tracing";
  Result<ExplainReport> report =
      realtime
          ? explain_realtime_pixel(scene, *realtime, {options.render.width, options.render.height},
                                   {options.pixel->x, options.pixel->y}, options.sample)
          : explain_pixel(scene, options.render, options.pixel->x, options.pixel->y,
                          options.sample);
  if (!report) {
    const Outcome outcome = outcome_of(report.error(), context);
    if (options.json) {
      return worse(outcome.status,
                   answer(explain_json(scene, options.render, nullptr, outcome.error, realtime)));
    }
    say_error(outcome.error);
    return outcome.status;
  }
  if (!options.mine.empty()) {
    const std::uint8_t* const v = mine.picture.texture.texel(options.pixel->x, options.pixel->y);
    add_yours(scene, {v[0], v[1], v[2]}, *report);
  }
  if (options.json) {
    return answer(explain_json(scene, options.render, &*report));
  }
  const ExplainStyle style{wants_color(Stream::answer), wants_swatches(Stream::answer)};
  return answer(explain_text(scene, *report, style));
}

}  // namespace scenefile::app
