#include "scenefile/verbs/explain.h"

#include "app/command.h"
#include "app/diff_paths.h"
#include "app/load.h"
#include "app/load_picture.h"
#include "app/output.h"
#include "app/realtime.h"
#include "scenefile/base/text.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>

namespace scenefile::app {

namespace {

// Reads --mine and --reference. Without --size and --reference, --mine determines the size.
ExitCode load_pictures(Options& options, LoadedPicture& mine, LoadedPicture& reference,
                       Context& context) {
  if (options.mine.empty()) {
    return ExitCode::fine;
  }
  mine = load_picture({options.mine}, options.layer, context);
  if (!options.reference.empty()) {
    reference = load_picture({options.reference}, options.layer, context);
  }
  for (const LoadedPicture* picture : {&mine, &reference}) {
    if (!picture->error.empty()) {
      return fail(picture->status, picture->error);
    }
  }
  const Texture& picture = mine.picture.texture;
  if (!was_given(options, "--size")) {
    options.render.width = picture.width;
    options.render.height = picture.height;
  } else if (options.render.width != picture.width || options.render.height != picture.height) {
    return fail(
        ExitCode::usage,
        fmt::format(
            "{} is {}x{}, but the size asked for is {}x{}; {}", quoted(options.mine, 400),
            picture.width, picture.height, options.render.width, options.render.height,
            options.render.mode == Mode::path
                ? fmt::format("--size {}x{} asks for its own", picture.width, picture.height)
                : "for a part of a picture or a screenshot, --reference PICTURE "
                  "finds the place"));
  }
  if (options.pixel->x >= picture.width || options.pixel->y >= picture.height) {
    return fail(ExitCode::usage,
                fmt::format("--pixel: {},{} is not in the picture: 0,0 to {},{}", options.pixel->x,
                            options.pixel->y, picture.width - 1, picture.height - 1));
  }
  return ExitCode::fine;
}

// Zeros if there is no picture.
std::array<std::uint8_t, 3> value_at(const Texture& picture, const PixelPlace& pixel) {
  if (picture.empty()) {
    return {};
  }
  const std::uint8_t* const v = picture.texel(pixel.x, pixel.y);
  return {v[0], v[1], v[2]};
}

// Compares a path-traced picture with the truth.
Outcome add_around(const LoadedScene& scene, const Options& options, const LoadedPicture& mine,
                   Context& context, ExplainReport& report) {
  PathTruth truth;
  PathVerdict verdict;
  Outcome outcome = judge_by_truth(scene, options, context, mine.picture, truth, verdict);
  if (outcome.error.empty()) {
    report.around = neighborhood(truth, std::move(verdict), {options.pixel->x, options.pixel->y});
  }
  return outcome;
}

// Compares the pictures, and sets the options to those of the picture of the scene.
Result<PictureComparison> compare_whole(Options& options, LoadedPicture& reference,
                                        LoadedPicture& mine, const LoadedScene& scene,
                                        Context& context) {
  round_alike(reference.picture, mine.picture);
  PictureComparison found = compare_loaded(reference, mine, &scene, options, context,
                                           glm::ivec2(options.pixel->x, options.pixel->y));
  if (!found.asked) {
    return Error{found.measures.comparable
                     ? fmt::format("--pixel: {},{} is outside of the part of {} that shows the "
                                   "scene: {}",
                                   options.pixel->x, options.pixel->y, quoted(options.mine, 400),
                                   found.broken.front())
                     : found.broken.front(),
                 ErrorKind::input};
  }
  if (!found.drawn_with.empty() && !found.realtime) {
    options.render = found.drawn_options;
  }
  options.render.width = found.asked_of.x;
  options.render.height = found.asked_of.y;
  options.pixel = {found.asked->x, found.asked->y};
  return found;
}

}  // namespace

ExitCode run_explain(const Options& given, Context& context) {
  Options options = given;
  LoadedPicture mine;
  LoadedPicture reference;
  if (const ExitCode status = load_pictures(options, mine, reference, context);
      status != ExitCode::fine) {
    return status;
  }
  const bool whole = !options.reference.empty();
  LoadedScene scene = whole ? load_scene_of_pictures(options.arguments.front(), options, context)
                            : load_for_tracing(options, context);
  if (options.seconds > 0 && !was_given(options, "--samples")) {
    options.render.samples = path_samples;  // the time is for the truth
  }
  std::optional<RealtimeOptions> realtime = realtime_options(options);
  if (realtime && status_of(scene) == ExitCode::fine) {
    check_realtime(*realtime, scene);
  }
  if (!options.json && !whole) {
    say(findings_text(scene, options.quiet ? Verbosity::errors : Verbosity::warnings,
                      wants_color(Stream::chatter)));
  }
  const auto failed = [&](const Outcome& outcome) {
    return options.json ? answer_json(outcome, explain_json(scene, options.render, nullptr,
                                                            outcome.error, realtime))
                        : fail(outcome);
  };
  if (const Outcome unusable = outcome_of(scene); unusable.status != ExitCode::fine) {
    return options.json ? failed(unusable) : unusable.status;
  }
  const std::array value = value_at(mine.picture.texture, *options.pixel);
  std::optional<PictureComparison> found;
  if (whole) {
    Result<PictureComparison> compared = compare_whole(options, reference, mine, scene, context);
    if (!compared) {
      return failed(outcome_of(compared.error(), context));
    }
    found = *std::move(compared);
    realtime = found->realtime;
  }
  context.phase = "tracing";
  Result<ExplainReport> report =
      realtime
          ? explain_realtime_pixel(scene, *realtime, {options.render.width, options.render.height},
                                   {options.pixel->x, options.pixel->y}, options.sample)
          : explain_pixel(scene, options.render, options.pixel->x, options.pixel->y,
                          options.sample);
  if (!report) {
    return failed(outcome_of(report.error(), context));
  }
  if (report->path && !options.mine.empty()) {
    if (const Outcome outcome = add_around(scene, options, mine, context, *report);
        !outcome.error.empty()) {
      return failed(outcome);
    }
  } else if (found) {
    add_compared(scene, value, *std::move(found), *report);
  } else if (!options.mine.empty()) {
    add_yours(scene, value, *report);
  }
  if (options.json) {
    return answer(explain_json(scene, options.render, &*report));
  }
  const ExplainStyle style{wants_color(Stream::answer), wants_swatches(Stream::answer)};
  return answer(explain_text(scene, *report, style));
}

}  // namespace scenefile::app
