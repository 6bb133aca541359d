#include "scenefile/trace/render.h"

#include "app/checkpoint.h"
#include "app/command.h"
#include "app/json.h"
#include "app/load.h"
#include "app/named_files.h"
#include "app/output.h"
#include "app/pictures.h"
#include "app/progress.h"
#include "app/realtime.h"
#include "app/render_part.h"
#include "scenefile/base/hash.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"
#include "scenefile/io/interrupt.h"
#include "scenefile/path/render_path.h"
#include "scenefile/trace/layers.h"
#include "scenefile/trace/picture_state.h"
#include "scenefile/trace/trace_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile::app {

namespace {

using Clock = std::chrono::steady_clock;

PixelRegion drawn_region(const RenderOptions& options) {
  return options.crop.value_or(PixelRegion{0, 0, options.width, options.height});
}

Outcome claim_render_outputs(const Options& options, Context& context) {
  std::vector<UsedFile> outputs;
  for (const std::string& file : picture_files(options)) {
    outputs.push_back(named_file(outputs.empty() ? "output" : "layer", file));
  }
  Outcome refused = claim_outputs(outputs, context);
  return refused.status == ExitCode::fine ? check_named_outputs(options) : refused;
}

// Returns the scene to draw, and frees its groups.
RenderResult trace(const Options& options, LoadedScene& scene, const RenderOptions& render_options,
                   Checkpoints checkpoints) {
  ProgressBar bar(!options.quiet && !options.json && wants_progress());
  const Progress progress = [&](double done) {
    bar.update(done);
    return DeferredSignals::pending() == 0;
  };
  const PixelRegion drawn = drawn_region(render_options);
  RenderScene& ready = scene.ready.scene;
  const TraceScene traced(ready, scene.assets, {.threads = render_options.threads});
  if (!options.json) {
    std::vector<RenderGroup>().swap(ready.groups);  // only needed while building
  }
  return render(ready, scene.assets, render_options,
                {.progress = progress,
                 .checkpoints = std::move(checkpoints),
                 .preview = preview_of(options),
                 .canvas = canvas(drawn.width(), drawn.height()),
                 .traced = &traced});
}

// The same for paths. Sets the number of samples taken.
RenderResult trace_paths(const Options& options, LoadedScene& scene, RenderReport& report) {
  ProgressBar bar(!options.quiet && !options.json && wants_progress());
  const Progress progress = [&](double done) {
    bar.update(done);
    return DeferredSignals::pending() == 0;
  };
  PathResult path = render_path(
      scene.ready.scene, scene.assets, report.options,
      {.progress = progress, .preview = preview_of(options), .seconds = options.seconds});
  report.options.samples = static_cast<int>(path.samples);
  if (path.state.dropped > 0 && !options.quiet) {
    say(fmt::format("warning: {} sample{} not finite; their light is missing\n", path.state.dropped,
                    path.state.dropped == 1 ? " was" : "s were"));
  }
  RenderResult result;
  result.image = std::move(path.image);
  result.status = path.status;
  result.stats = path.stats;
  return result;
}

// `picture`: the picture that options.part is a part of; null for a whole picture.
Outcome draw(const Options& options, LoadedScene& scene, const DividedPicture* picture,
             RenderReport& report, Context& context) {
  context.phase = "reading the checkpoint";
  Checkpoints checkpoints;
  std::optional<DeferredSignals> deferred;
  if (!options.checkpoint.empty()) {
    Outcome refused = open_checkpoint(options, scene, checkpoints);
    if (refused.status != ExitCode::fine) {
      return refused;
    }
    deferred.emplace();
  }
  if (const std::string missing =
          missing_light(report.options.layers, scene.ready.scene.lights.size());
      !missing.empty()) {
    return {ExitCode::usage, "--aov: " + missing};
  }
  if (!options.json) {
    forget_file(scene);
  }
  context.phase = "tracing";
  RenderResult result;
  if (report.options.mode == Mode::path) {
    result = trace_paths(options, scene, report);
  } else if (drawn_region(report.options).width() > 0) {
    result = trace(options, scene, report.options, std::move(checkpoints));
  }
  deferred.reset();
  report.stats = result.stats;
  Outcome outcome = outcome_of(result.status, context);
  if (result.status == RenderStatus::cancelled && !options.checkpoint.empty()) {
    outcome.error += "; the same command continues from the checkpoint";
  }
  if (outcome.error.empty()) {
    outcome = picture != nullptr ? write_part(options, *picture, result, context)
                                 : write_pictures(options, result, context);
  }
  if (outcome.error.empty() && !options.checkpoint.empty()) {
    remove_checkpoint(options);
  }
  return outcome;
}

std::string work_text(const RenderReport& report) {
  if (!report.gl.renderer.empty()) {
    return fmt::format("{} draw call{} for {} object{}", report.gl.draw_calls,
                       report.gl.draw_calls == 1 ? "" : "s", report.gl.objects,
                       report.gl.objects == 1 ? "" : "s");
  }
  const std::uint64_t rays =
      report.stats.primary_rays + report.stats.shadow_rays + report.stats.secondary_rays;
  const std::string samples = report.options.mode == Mode::path
                                  ? fmt::format("{} samples per pixel, ", report.options.samples)
                                  : std::string();
  return fmt::format("{}{:.2f} million rays", samples, static_cast<double>(rays) / 1e6);
}

// The requested part of the picture that OpenGL drew, or the whole picture.
Outcome write_drawn(const Options& options, const Image& drawn, DividedPicture* picture,
                    const RenderReport& report, Context& context) {
  if (picture == nullptr) {
    return write_8bit_picture(options, drawn, context);
  }
  Hash renderer;
  renderer.add(report.gl.renderer);
  picture->key.driver = renderer.value();
  RenderResult part;
  const PixelRegion whole{0, 0, drawn.width, drawn.height};
  part.image = cut(drawn, whole, report.part->region);
  return write_part(options, *picture, part, context);
}

std::string part_text(const RenderReport& report) {
  if (!report.part) {
    return {};
  }
  return fmt::format("part {} of {}", report.part->index + 1, report.part->count);
}

std::string summary_text(const RenderReport& report) {
  const std::string name = report.output == "-" ? "<stdout>" : escaped(report.output);
  if (report.part && report.part->skipped) {
    return fmt::format("{}: {} already exists\n", name, part_text(report));
  }
  const PixelRegion drawn = report.part ? report.part->region : drawn_region(report.options);
  return fmt::format("{}: {}{}{}x{}, {:.2f} s, {}\n", name, part_text(report),
                     report.part ? ", " : "", drawn.width(), drawn.height(), report.seconds,
                     work_text(report));
}

}  // namespace

ExitCode run_render(const Options& given, Context& context) {
  Options options = given;
  const Clock::time_point start = Clock::now();
  RenderReport report;
  report.options = options.render;
  report.output = options.output;
  if (Outcome refused = claim_render_outputs(options, context); refused.status != ExitCode::fine) {
    LoadedScene unread;
    unread.path = options.arguments.front();
    report.error = std::move(refused.error);
    if (options.json) {
      return worse(refused.status, answer(render_json(unread, report)));
    }
    say_error(report.error);
    return refused.status;
  }
  LoadedScene scene = load_scene(options.arguments.front(), options, depth_for(options.render),
                                 options.load.allow_missing, context);
  choose_path_mode(scene, options);
  report.options = options.render;
  check_picture(scene, options.render);
  Outcome outcome{status_of(scene), {}};
  if (const auto realtime = realtime_options(options);
      realtime && outcome.status == ExitCode::fine) {
    check_realtime(*realtime, scene);
    report.realtime = realtime_report(*realtime, scene);
  }
  std::optional<DividedPicture> divided;
  if (options.part && outcome.status == ExitCode::fine) {
    context.phase = "checking the part";
    divided = divided_picture(options, scene);
    const auto [index, count] = *options.part;
    report.part = {index, count, part_of(divided->region, index, count)};
    outcome = find_part(options, *divided, report.part->skipped);
    options.render.crop = report.options.crop = report.part->region;
  }
  DividedPicture* const picture = divided ? &*divided : nullptr;
  const bool wanted = outcome.status == ExitCode::fine && !(report.part && report.part->skipped);
  Image drawn;
  if (options.engine == Engine::gl && wanted) {
    outcome = GlPainter(options, scene).draw(drawn, report.gl, context);
    if (outcome.status == ExitCode::fine) {
      report.options.samples = report.gl.samples;
    }
  }
  if (!options.json) {
    say(findings_text(scene, options.quiet ? Verbosity::errors : Verbosity::warnings,
                      wants_color(Stream::chatter)));
  }
  if (wanted && outcome.status == ExitCode::fine) {
    outcome = options.engine == Engine::gl ? write_drawn(options, drawn, picture, report, context)
                                           : draw(options, scene, picture, report, context);
  } else if (outcome.status != ExitCode::fine && outcome.error.empty()) {
    outcome.error = "the scene cannot be used";
  }
  report.options.crop = given.render.crop;
  report.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  report.error = outcome.error;
  if (options.json) {
    return worse(outcome.status, answer(render_json(scene, report)));
  }
  if (status_of(scene) == ExitCode::fine && !outcome.error.empty()) {
    say_error(outcome.error);
  } else if (outcome.status == ExitCode::fine && !options.quiet) {
    say_afterwards([&] { return summary_text(report); });
  }
  return outcome.status;
}

}  // namespace scenefile::app
