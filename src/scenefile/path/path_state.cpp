#include "scenefile/path/path_state.h"

#include "scenefile/path/path_kernel.h"
#include "scenefile/path/path_layers.h"
#include "scenefile/trace/denoise.h"
#include "scenefile/trace/tiles.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace scenefile {

PixelRegion drawn_pixels(const RenderOptions& options) {
  return options.crop.value_or(PixelRegion{0, 0, options.width, options.height});
}

PathState make_path_state(const RenderOptions& options) {
  const RenderOptions valid = in_range(options);
  PathState state;
  state.region = drawn_pixels(valid);
  if (valid.denoise) {
    PixelRegion& r = state.region;
    r = {std::max(0, r.x0 - path_denoise_reach), std::max(0, r.y0 - path_denoise_reach),
         std::min(valid.width, r.x1 + path_denoise_reach),
         std::min(valid.height, r.y1 + path_denoise_reach)};
  }
  const std::size_t pixels = std::size_t(state.region.width()) * state.region.height();
  state.sums.resize(pixels);
  state.squares.resize(pixels);
  state.counts.resize(pixels);
  state.layers.resize(valid.layers.size(), std::vector<glm::dvec3>(pixels));
  state.guides.resize(valid.denoise ? pixels : 0);
  return state;
}

bool add_sample(const Color& light, std::size_t at, PathState& state) {
  const double bright = luminance(light);
  const bool finite = std::isfinite(bright * bright);
  if (finite) {
    state.sums[at] += light;
    state.squares[at] += bright * bright;
  }
  ++state.counts[at];
  return finite;
}

RenderStatus add_samples(const PathScene& scene, std::uint32_t samples, PathState& state,
                         const Progress& progress, RenderStats& stats, int stride) {
  const PixelRegion& region = state.region;
  std::atomic<std::uint64_t> primary{0}, shadow{0}, secondary{0}, dropped{0};
  const bool recorded = !state.layers.empty() || !state.guides.empty();
  ProgressMonitor monitor(progress);
  const auto given_up = [&] { return monitor.stopped() || scene.tracer.accelerator.overwhelmed(); };
  TileFlags tiles(region.width(), region.height());
  for_each_unfinished_tile(tiles, {}, monitor, [&](const Tile& tile) {
    RayCounts counts;
    std::uint64_t bad = 0;
    PathRecord path;
    const auto next = [&](int at) { return (at + stride - 1) / stride * stride; };
    for (int y = next(tile.y0); y < tile.y1 && !given_up(); y += stride) {
      for (int x = next(tile.x0); x < tile.x1; x += stride) {
        const std::size_t at = std::size_t(y) * region.width() + x;
        while (state.counts[at] < samples) {
          const Color light = path_light(scene, region.x0 + x, region.y0 + y, state.counts[at],
                                         counts, recorded ? &path : nullptr);
          const bool finite = add_sample(light, at, state);
          bad += finite ? 0 : 1;
          if (recorded && finite) {
            add_layers(path, scene.options, at, state);
          }
        }
      }
    }
    primary += counts.primary;
    shadow += counts.shadow;
    secondary += counts.secondary;
    dropped += bad;
    return true;
  });
  stats.primary_rays += primary;
  stats.shadow_rays += shadow;
  stats.secondary_rays += secondary;
  state.dropped += dropped;
  return scene.tracer.accelerator.overwhelmed() ? RenderStatus::limit_reached
         : monitor.stopped()                    ? RenderStatus::cancelled
                                                : RenderStatus::complete;
}

Image image_of(const PathState& state) {
  Image image(state.region.width(), state.region.height());
  for (std::size_t i = 0; i < state.sums.size(); ++i) {
    const Color mean = state.sums[i] / double(std::max(1u, state.counts[i]));
    for (int c = 0; c < 3; ++c) {
      image.rgb[3 * i + c] = stored_float(mean[c]);
    }
  }
  return image;
}

std::vector<float> variances_of(const PathState& state) {
  std::vector<float> variances(state.sums.size());
  for (std::size_t i = 0; i < variances.size(); ++i) {
    const double n = state.counts[i];
    if (n > 1) {
      const double mean = luminance(state.sums[i]) / n;
      variances[i] = stored_float(std::max((state.squares[i] / n - mean * mean) / (n - 1), 0.0));
    }
  }
  return variances;
}

}  // namespace scenefile
