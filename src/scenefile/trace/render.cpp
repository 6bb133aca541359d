#include "scenefile/trace/render.h"

#include "scenefile/trace/film.h"
#include "scenefile/trace/preview_picture.h"
#include "scenefile/trace/render_pass.h"
#include "scenefile/trace/tiles.h"

#include <chrono>
#include <optional>
#include <utility>

namespace scenefile {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void put_picture(Film film, RenderResult& result) {
  Resolved resolved = resolve(std::move(film));
  result.image = std::move(resolved.image);
  result.layers = std::move(resolved.layers);
}

// Draws all passes, with callbacks.
void render_passes(const Tracer& tracer, const RenderControl& control, Film& film,
                   RenderResult& result) {
  PreviewPicture shown(control.preview, film);
  const Progress showing = [&](double done) {
    shown.show_in_time();
    return !control.progress || control.progress(done);
  };
  if (shown.wanted()) {
    shown.start(tracer);
  }
  while (!complete(film) && result.status == RenderStatus::complete) {
    result.status =
        render_pass(tracer, film, shown.wanted() ? showing : control.progress, &result.stats);
    if (shown.wanted()) {
      shown.update();
    }
  }
}

}  // namespace

RenderResult render(const RenderScene& scene, const Assets& assets, const RenderOptions& options,
                    RenderControl control) {
  RenderResult result;
  const ThreadLimit limit(options.threads);
  std::optional<TraceScene> built;
  if (control.traced == nullptr) {
    built.emplace(scene, assets);
  }
  const TraceScene& traced = control.traced != nullptr ? *control.traced : *built;
  result.stats.build_seconds = traced.build_seconds();
  result.status = traced.status();
  const Clock::time_point start = Clock::now();
  Film film = make_film(scene, options, std::move(control.canvas));
  if (result.status == RenderStatus::complete) {
    render_passes(Tracer(traced, scene, options), control, film, result);
  }
  put_picture(std::move(film), result);
  if (control.preview.show) {
    control.preview.show(result.image);
  }
  result.stats.trace_seconds = seconds_since(start);
  return result;
}

}  // namespace scenefile
