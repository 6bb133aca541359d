#include "scenefile/path/path_state.h"

#include "scenefile/path/path_kernel.h"
#include "scenefile/trace/tiles.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace scenefile {

PathState make_path_state(const RenderOptions& options) {
  const RenderOptions valid = in_range(options);
  PathState state;
  state.region = valid.crop.value_or(PixelRegion{0, 0, valid.width, valid.height});
  const std::size_t pixels = std::size_t(state.region.width()) * state.region.height();
  state.sums.resize(pixels);
  state.squares.resize(pixels);
  state.counts.resize(pixels);
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
                         const Progress& progress, RenderStats& stats) {
  const PixelRegion& region = state.region;
  std::atomic<std::uint64_t> primary{0}, shadow{0}, secondary{0}, dropped{0};
  Watch watch(progress);
  const auto given_up = [&] { return watch.stopped() || scene.tracer.accelerator.overwhelmed(); };
  Pieces tiles(region.width(), region.height());
  for_each_piece(tiles, {}, watch, [&](const Tile& tile) {
    RayCounts counts;
    std::uint64_t bad = 0;
    for (int y = tile.y0; y < tile.y1 && !given_up(); ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) {
        const std::size_t at = std::size_t(y) * region.width() + x;
        while (state.counts[at] < samples) {
          bad += !add_sample(
              path_light(scene, region.x0 + x, region.y0 + y, state.counts[at], counts), at, state);
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
         : watch.stopped()                      ? RenderStatus::cancelled
                                                : RenderStatus::complete;
}

Image image_of(const PathState& state) {
  Image image(state.region.width(), state.region.height());
  for (std::size_t i = 0; i < state.sums.size(); ++i) {
    const Color mean = state.sums[i] / double(std::max(1u, state.counts[i]));
    for (int c = 0; c < 3; ++c) {
      // Within the range of floats.
      image.rgb[3 * i + c] = static_cast<float>(std::min(mean[c], 1e38));
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
      variances[i] =
          static_cast<float>(std::clamp((state.squares[i] / n - mean * mean) / (n - 1), 0.0, 1e38));
    }
  }
  return variances;
}

}  // namespace scenefile
