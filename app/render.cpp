#include "scenefile/trace/render.h"

#include "app/assemble.h"
#include "app/band_store.h"
#include "app/command.h"
#include "app/item_key.h"
#include "app/json.h"
#include "app/load.h"
#include "app/named_files.h"
#include "app/output.h"
#include "app/pictures.h"
#include "app/progress.h"
#include "app/realtime.h"
#include "scenefile/base/text.h"
#include "scenefile/io/interrupt.h"
#include "scenefile/io/parallel.h"
#include "scenefile/trace/film.h"
#include "scenefile/trace/layers.h"
#include "scenefile/trace/trace_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <memory>
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
  if (options.part || options.missing) {
    return {};  // only writes bands
  }
  std::vector<UsedFile> outputs;
  for (const std::string& file : picture_files(options)) {
    outputs.push_back(named_file(outputs.empty() ? "output" : "layer", file));
  }
  Outcome refused = claim_outputs(outputs, context);
  return refused.status == ExitCode::fine ? check_named_outputs(options) : refused;
}

// Draws pictures of one scene, of which the structure is built once.
class Drawing {
 public:
  Drawing(const Options& options, LoadedScene& scene)
      : options_(options),
        scene_(scene),
        traced_(scene.ready.scene, scene.assets, {.threads = options.render.threads}) {
    if (!options.json && options.render.mode != Mode::path) {
      std::vector<RenderGroup>().swap(scene.ready.scene.groups);  // only needed while building
    }
  }

  // Adds its work to the report.
  RenderResult draw(const RenderOptions& options, const Progress& progress, RenderReport& report,
                    Image canvas = {}) {
    RenderResult result = trace_picture(options_, options, scene_, traced_, progress,
                                        std::move(canvas), &report.options.samples);
    report.stats.build_seconds = result.stats.build_seconds;
    report.stats.primary_rays += result.stats.primary_rays;
    report.stats.shadow_rays += result.stats.shadow_rays;
    report.stats.secondary_rays += result.stats.secondary_rays;
    report.stats.trace_seconds += result.stats.trace_seconds;
    return result;
  }

 private:
  const Options& options_;
  LoadedScene& scene_;
  TraceScene traced_;
};

Outcome draw(const Options& options, LoadedScene& scene, RenderReport& report, Context& context) {
  if (!options.json) {
    forget_file(scene);
  }
  context.phase = "tracing";
  ProgressBar bar(!options.quiet && !options.json && wants_progress());
  const Progress progress = [&](double done) {
    bar.update(done);
    return true;
  };
  const PixelRegion drawn = drawn_region(report.options);
  const RenderResult result =
      Drawing(options, scene)
          .draw(report.options, progress, report, canvas(drawn.width(), drawn.height()));
  const Outcome outcome = outcome_of(result.status, context);
  return outcome.error.empty() ? write_pictures(options, result, context) : outcome;
}

// The bands that are missing in the share, not higher than is good for this machine.
std::vector<RowRange> bands_to_draw(const Options& options, const RenderScene& scene,
                                    const BandStore& store, const RowRange& share) {
  const RenderOptions& render = options.render;
  const int most = rows_of_band(store.width(), store.picture().rows(),
                                render.mode == Mode::path ? 0 : margin_of(scene, render),
                                thread_count(render.threads));
  std::vector<RowRange> bands;
  for (const RowRange& rows : store.missing(share)) {
    const auto count = static_cast<std::uint32_t>((rows.rows() + most - 1) / most);
    for (std::uint32_t i = 0; i < count; ++i) {
      bands.push_back(share_of(rows, i, count));
    }
  }
  return bands;
}

// Draws these bands into the store. A signal ends it; finished bands are kept. With several
// threads, a band is packed and written while the next one is drawn.
Outcome draw_bands(const Options& options, LoadedScene& scene, const std::vector<RowRange>& bands,
                   BandStore& store, RenderReport& report, Context& context) {
  ProgressBar bar(!options.quiet && !options.json && wants_progress());
  const PixelRegion picture = drawn_region(options.render);
  double rows = 0;
  for (const RowRange& band : bands) {
    rows += band.rows();
  }
  double before = 0;
  std::optional<Drawing> drawing;
  std::future<Outcome> writing;
  Outcome outcome;
  const auto finish_writing = [&] {
    if (writing.valid() && outcome.error.empty()) {
      outcome = writing.get();
      report.store->drawn += outcome.error.empty() ? 1 : 0;
    }
    return outcome.error.empty();
  };
  for (const RowRange& band : bands) {
    context.phase = "tracing";
    const Progress progress = [&](double done) {
      bar.update((before + done * band.rows()) / rows);
      return DeferredSignals::pending() == 0;
    };
    if (!drawing) {
      drawing.emplace(options, scene);
    }
    RenderOptions of_band = options.render;
    of_band.crop = {picture.x0, picture.y0 + band.first, picture.x1, picture.y0 + band.end};
    RenderResult result = drawing->draw(of_band, progress, report);
    if (!finish_writing()) {
      return outcome;
    }
    outcome = outcome_of(result.status, context);
    if (!outcome.error.empty()) {
      outcome.error +=
          result.status == RenderStatus::cancelled ? "; the same command continues" : "";
      return outcome;
    }
    // Deferred if there is no other thread; not a temporary, because a failed start would empty it.
    const auto write = [&store, band, made = std::make_shared<RenderResult>(std::move(result))] {
      return store.write(band, std::move(*made));
    };
    writing = std::async(options.render.threads == 1 ? std::launch::deferred
                                                     : std::launch::async | std::launch::deferred,
                         write);
    before += band.rows();
  }
  context.phase = "writing a band";
  finish_writing();
  return outcome;
}

// With --store: draws what is missing, and writes the picture if all is there.
Outcome draw_with_store(const Options& options, LoadedScene& scene, RenderReport& report,
                        Context& context) {
  BandStore store(options, scene);
  Outcome outcome = store.open(context);
  report.store->found = store.current();
  if (outcome.status != ExitCode::fine) {
    return outcome;
  }
  if (options.missing) {
    for (std::uint32_t i = 0; i < *options.missing; ++i) {
      if (!store.missing(share_of(store.picture(), i, *options.missing)).empty()) {
        report.store->missing.push_back(i + 1);
      }
    }
    return {};
  }
  const RowRange share = options.part
                             ? share_of(store.picture(), options.part->index, options.part->count)
                             : store.picture();
  const std::vector<RowRange> bands = bands_to_draw(options, scene.ready.scene, store, share);
  outcome = store.claim(bands, context);
  if (outcome.status != ExitCode::fine) {
    return outcome;
  }
  if (!options.json) {
    forget_file(scene);
  }
  const DeferredSignals deferred;
  outcome = draw_bands(options, scene, bands, store, report, context);
  return outcome.error.empty() && !options.part ? assemble(options, store, context) : outcome;
}

std::string work_text(const RenderReport& report) {
  if (!report.gl.renderer.empty()) {
    return fmt::format("{} for {}", counted(report.gl.draw_calls, "draw call"),
                       counted(report.gl.objects, "object"));
  }
  const std::uint64_t rays =
      report.stats.primary_rays + report.stats.shadow_rays + report.stats.secondary_rays;
  const std::string samples = report.options.mode == Mode::path
                                  ? counted(report.options.samples, "sample") + " per pixel, "
                                  : std::string();
  return fmt::format("{}{:.2f} million rays", samples, static_cast<double>(rays) / 1e6);
}

std::string bands_text(std::size_t count, std::string_view done) {
  return fmt::format("{} {}", counted(count, "band"), done);
}

std::string summary_text(const Options& options, const RenderReport& report) {
  const PixelRegion drawn = drawn_region(report.options);
  std::string text = report.output == "-" ? "<stdout>" : escaped(report.output);
  if (options.part) {
    text = fmt::format("{}: share {} of {}", escaped(options.store), options.part->index + 1,
                       options.part->count);
  }
  text += fmt::format(": {}x{}, ", drawn.width(), drawn.height());
  if (report.store) {
    text += fmt::format("{}, {}, ", bands_text(report.store->drawn, "drawn"),
                        bands_text(report.store->found, "found"));
  }
  return text + fmt::format("{:.2f} s, {}\n", report.seconds, work_text(report));
}

}  // namespace

ExitCode run_render(const Options& given, Context& context) {
  Options options = given;
  const Clock::time_point start = Clock::now();
  RenderReport report;
  report.options = options.render;
  report.output = options.output;
  if (const Outcome refused = claim_render_outputs(options, context);
      refused.status != ExitCode::fine) {
    LoadedScene unread;
    unread.path = options.arguments.front();
    report.error = refused.error;
    return options.json ? answer_json(refused, render_json(unread, report)) : fail(refused);
  }
  LoadedScene scene = load_for_tracing(options, context);
  report.options = options.render;
  Outcome outcome = outcome_of(scene);
  if (const auto realtime = realtime_options(options);
      realtime && outcome.status == ExitCode::fine) {
    check_realtime(*realtime, scene);
    report.realtime = realtime_report(*realtime, scene);
  }
  if (!options.store.empty()) {
    report.store.emplace();
  }
  if (const std::string missing =
          missing_light(options.render.layers, scene.ready.scene.lights.size());
      outcome.status == ExitCode::fine && !missing.empty()) {
    outcome = {ExitCode::usage, "--aov: " + missing};
  }
  Image drawn;
  if (options.engine == Engine::gl && outcome.status == ExitCode::fine) {
    outcome = GlPainter(options, scene).draw(drawn, report.gl, context);
    if (outcome.status == ExitCode::fine) {
      report.options.samples = report.gl.samples;
    }
  }
  if (!options.json) {
    say(findings_text(scene, options.quiet ? Verbosity::errors : Verbosity::warnings,
                      wants_color(Stream::chatter)));
  }
  if (outcome.status == ExitCode::fine) {
    outcome = options.engine == Engine::gl ? write_8bit_picture(options, drawn, context)
              : report.store               ? draw_with_store(options, scene, report, context)
                                           : draw(options, scene, report, context);
  }
  report.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  report.error = outcome.error;
  report.written = outcome.error.empty() && !options.part && !options.missing;
  if (options.json) {
    const bool missing = report.store && !report.store->missing.empty();
    return worse(missing ? ExitCode::findings : ExitCode::fine,
                 answer_json(outcome, render_json(scene, report)));
  }
  if (options.missing && outcome.status == ExitCode::fine) {
    return answer_missing(report.store->missing);
  }
  if (status_of(scene) == ExitCode::fine && !outcome.error.empty()) {
    say_error(outcome.error);
  } else if (outcome.status == ExitCode::fine && !options.quiet) {
    say_afterwards([&] { return summary_text(options, report); });
  }
  return outcome.status;
}

}  // namespace scenefile::app
