#include "scenefile/path/render_path.h"

#include "scenefile/path/path_scene.h"
#include "scenefile/trace/film.h"
#include "scenefile/trace/tasks.h"

#include <algorithm>
#include <chrono>
#include <optional>

namespace scenefile {

namespace {

using PathClock = std::chrono::steady_clock;

double elapsed_since(PathClock::time_point start) {
  return std::chrono::duration<double>(PathClock::now() - start).count();
}

// Draws passes of 1, 1, 2, 4, ... samples, or a single one if time does not limit them.
void draw_passes(const PathScene& scene, const PathControl& control, PathClock::time_point start,
                 PathResult& result) {
  const auto most = static_cast<std::uint32_t>(scene.options.samples);
  const bool one_pass = control.seconds <= 0;
  const PathClock::time_point first = PathClock::now();
  while (result.samples < most && result.status == RenderStatus::complete) {
    std::uint32_t target = one_pass ? most : std::clamp(2 * result.samples, 1u, most);
    if (control.seconds > 0 && result.samples > 0) {
      const double left = control.seconds - elapsed_since(start);
      const double more = left / elapsed_since(first) * result.samples;
      if (more < 1) {
        break;
      }
      target = static_cast<std::uint32_t>(std::min<double>(target, result.samples + more));
    }
    const double done = double(result.samples) / most;
    const double share = double(target - result.samples) / most;
    const Progress progress = [&](double of_pass) {
      return !control.progress || control.progress(done + share * of_pass);
    };
    result.status = add_samples(scene, target, result.state, progress, result.stats);
    if (result.status == RenderStatus::complete) {
      result.samples = target;
    }
  }
}

}  // namespace

PathResult render_path(const RenderScene& scene, const Assets& assets, const RenderOptions& options,
                       const PathControl& control) {
  const PathClock::time_point start = PathClock::now();
  PathResult result;
  const ThreadLimit limit(options.threads);
  std::optional<TraceScene> built;
  if (control.traced == nullptr) {
    built.emplace(scene, assets);
  }
  const TraceScene& traced = control.traced != nullptr ? *control.traced : *built;
  result.stats.build_seconds = traced.build_seconds();
  result.status = traced.status();
  result.state = make_path_state(options);
  const PathClock::time_point tracing = PathClock::now();
  if (result.status == RenderStatus::complete) {
    draw_passes(PathScene(traced, scene, options), control, start, result);
  }
  const PixelRegion drawn = drawn_pixels(in_range(options));
  result.image = cut(options.denoise ? denoised_image_of(result.state) : image_of(result.state),
                     result.state.region, drawn);
  result.layers = layers_of(result.state, in_range(options), drawn);
  result.stats.trace_seconds = elapsed_since(tracing);
  return result;
}

}  // namespace scenefile
