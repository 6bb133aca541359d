#include "scenefile/trace/render_pass.h"

#include "scenefile/trace/edges.h"
#include "scenefile/trace/layer_buffers.h"
#include "scenefile/trace/pixel_sampler.h"
#include "scenefile/trace/tiles.h"

#include <algorithm>
#include <atomic>
#include <span>
#include <vector>

namespace scenefile {

namespace {

// Ray counts of all threads.
struct SharedCounts {
  std::atomic<std::uint64_t> primary{0};
  std::atomic<std::uint64_t> shadow{0};
  std::atomic<std::uint64_t> secondary{0};

  void add(const RayCounts& counts) {
    primary.fetch_add(counts.primary, std::memory_order_relaxed);
    shadow.fetch_add(counts.shadow, std::memory_order_relaxed);
    secondary.fetch_add(counts.secondary, std::memory_order_relaxed);
  }
};

// Calls f(x, y) for the pixels of a tile in an order that keeps neighbors together: blocks of 4 x
// 2.
template <typename F>
void for_each_in_blocks(const Tile& tile, const F& f) {
  constexpr int block_width = 4;
  constexpr int block_height = 2;
  for (int y0 = tile.y0; y0 < tile.y1; y0 += block_height) {
    for (int x0 = tile.x0; x0 < tile.x1; x0 += block_width) {
      for (int y = y0; y < std::min(y0 + block_height, tile.y1); ++y) {
        for (int x = x0; x < std::min(x0 + block_width, tile.x1); ++x) {
          f(x, y);
        }
      }
    }
  }
}

// Draws one pass. Coordinates are relative to the whole picture.
class Renderer {
 public:
  Renderer(const Tracer& tracer, const Progress& progress, Film& film)
      : tracer_(tracer),
        camera_(tracer.camera()),
        region_(film.region),
        monitor_(progress),
        film_(film),
        layers_(tracer, camera_, film),
        request_{!layers_.empty() || !film.statistics.empty(), layers_.lights(),
                 layers_.need_centers()} {}

  void run() {
    if (tracer_.course()) {
      run_course();
    } else {
      run_fine();
    }
  }

  RenderStatus status() const {
    if (tracer_.accelerator.overwhelmed()) {
      return RenderStatus::limit_reached;
    }
    return monitor_.stopped() ? RenderStatus::cancelled : RenderStatus::complete;
  }

  void add_rays(RenderStats& stats) const {
    stats.primary_rays += counts_.primary;
    stats.shadow_rays += counts_.shadow;
    stats.secondary_rays += counts_.secondary;
  }

 private:
  bool given_up() const { return monitor_.stopped() || tracer_.accelerator.overwhelmed(); }

  // Calls draw(pixels, counts) for each tile.
  template <typename F>
  void for_each_tile(PassShare share, const F& draw) {
    for_each_unfinished_tile(film_.tiles, share, monitor_, [&](const Tile& tile) {
      RayCounts counts;
      std::vector<glm::ivec2> pixels;
      pixels.reserve(std::size_t{tile_side} * tile_side);
      for_each_in_blocks(
          tile, [&](int x, int y) { pixels.emplace_back(x + region_.x0, y + region_.y0); });
      draw(pixels, counts);
      counts_.add(counts);
      return !given_up();
    });
  }

  // Calls draw(sampler, pixels) for each tile, with a sampler for each thread.
  template <typename F>
  void for_each_sampler(PassShare share, const F& draw) {
    const WavefrontScene scene(tracer_, camera_);
    WavefrontPool pool;
    for_each_tile(share, [&](std::vector<glm::ivec2>& pixels, RayCounts& counts) {
      PixelSampler sampler(scene, pool, request_, counts);
      draw(sampler, pixels);
    });
  }

  void run_course() {
    const bool one_sample = !camera_.has_lens() && !tracer_.options.features.super_sample;
    for_each_sampler({0, 1}, [&](PixelSampler& sampler, const std::vector<glm::ivec2>& pixels) {
      if (one_sample && !request_.wanted) {
        put_results(pixels, sampler.center_samples(pixels));
        return;
      }
      for (const SampledPixel& pixel : sampler.course(pixels)) {
        put(pixel.at, pixel.color);
        keep(pixel);
      }
    });
  }

  void run_fine() {
    const AdaptiveSampler sampler(tracer_, camera_);
    const SamplePlan& plan = sampler.plan();
    const double first_share = !plan.two_passes ? 1.0 : plan.centers_first ? 0.4 : 0.9;
    if (film_.pass == 0 && !film_.tiles.all_done()) {
      plan.centers_first ? take_center_samples(sampler, first_share)
                         : take_all(sampler, first_share);
      return;
    }
    if (film_.pass == 0) {
      find_refinement(sampler);
      film_.pass = 1;
      film_.tiles.restart();
    }
    monitor_.count(first_share);
    refine(sampler, first_share);
  }

  void take_center_samples(const AdaptiveSampler& fine, double share) {
    for_each_sampler({0, share}, [&](PixelSampler& sampler, const std::vector<glm::ivec2>& pixels) {
      if (!request_.wanted) {
        put_results(pixels, sampler.center_samples(fine, pixels));
        return;
      }
      for (const SampledPixel& pixel : sampler.take_center_samples(fine, pixels)) {
        put(pixel.at, pixel.samples.mean());
        keep(pixel);
        put_refinement(pixel.at, pixel.surface_hash);
      }
    });
  }

  void take_all(const AdaptiveSampler& fine, double share) {
    for_each_sampler({0, share}, [&](PixelSampler& sampler, const std::vector<glm::ivec2>& pixels) {
      const std::vector<std::uint16_t> refinements(pixels.size());
      const std::vector<SampledPixel> taken = sampler.take(fine, pixels, refinements);
      put_pixels(taken);
      for (const SampledPixel& pixel : taken) {
        put_refinement(pixel.at, pixel.samples.count < fine.plan().most ? 1 : 0);
      }
    });
  }

  void refine(const AdaptiveSampler& fine, double from) {
    for_each_sampler({from, 1}, [&](PixelSampler& sampler, std::vector<glm::ivec2>& pixels) {
      std::erase_if(pixels, [&](const glm::ivec2& at) { return !needs_refinement(at); });
      std::vector<std::uint16_t> refinements;
      for (const glm::ivec2& at : pixels) {
        refinements.push_back(film_.refinement_map[index(at)]);
      }
      put_pixels(sampler.take(fine, pixels, refinements));
    });
  }

  void put_pixels(const std::vector<SampledPixel>& pixels) {
    for (const SampledPixel& pixel : pixels) {
      put(pixel.at, pixel.samples.mean());
      keep(pixel);
    }
  }

  // The common case, with minimal work per pixel.
  void put_results(const std::vector<glm::ivec2>& pixels, std::span<const SampleResult> results) {
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      put(pixels[i], results[i].color);
      put_refinement(pixels[i], results[i].surface_hash);
    }
  }

  void put_refinement(const glm::ivec2& at, std::uint32_t surface_hash) {
    if (!film_.refinement_map.empty()) {
      film_.refinement_map[index(at)] = kept_hash(surface_hash);
    }
  }

  // Whether the pixel needs more samples.
  bool needs_refinement(const glm::ivec2& at) const {
    const PixelRegion& own = film_.own;
    return at.x >= own.x0 && at.x < own.x1 && at.y >= own.y0 && at.y < own.y1 &&
           film_.refinement_map[index(at)] != 0;
  }

  // Replaces what the first pass stored in the refinement map by how much each pixel must be
  // refined.
  void find_refinement(const AdaptiveSampler& fine) {
    const std::vector<std::uint16_t> stored = film_.refinement_map;
    for_each_row_of_contrasts(film_.image, stored, [&](int y, const RowOfContrasts& contrasts) {
      std::uint16_t* const refinements =
          &film_.refinement_map[std::size_t(y) * contrasts.most.size()];
      for (std::size_t x = 0; x < contrasts.most.size(); ++x) {
        const bool has_all = !fine.plan().centers_first && refinements[x] == 0;
        refinements[x] = has_all ? 0 : fine.refinement_of({contrasts.most[x], contrasts.edges[x]});
      }
    });
  }

  // Stores the recorded data of a pixel.
  void keep(const SampledPixel& pixel) {
    if (!layers_.empty()) {
      layers_.put(pixel.at.x, pixel.at.y, pixel.surfaces);
    }
    if (!film_.statistics.empty()) {
      film_.statistics[index(pixel.at)] = statistics_of(pixel.surfaces.samples, film_.sharp);
    }
  }

  void put(const glm::ivec2& at, const Color& color) {
    float* const pixel = &film_.image.rgb[3 * index(at)];
    for (int c = 0; c < 3; ++c) {
      pixel[c] = static_cast<float>(color[c]);
    }
  }

  std::size_t index(const glm::ivec2& at) const {
    return std::size_t(at.y - region_.y0) * region_.width() + (at.x - region_.x0);
  }

  const Tracer& tracer_;
  CameraRays camera_;
  PixelRegion region_;
  ProgressMonitor monitor_;
  Film& film_;
  LayerBuffers layers_;
  AovRequest request_;
  SharedCounts counts_;
};

}  // namespace

RenderStatus render_pass(const Tracer& tracer, Film& film, const Progress& progress,
                         RenderStats* stats) {
  if (tracer.status() != RenderStatus::complete || complete(film)) {
    return tracer.status();
  }
  Renderer renderer(tracer, progress, film);
  renderer.run();
  if (stats != nullptr) {
    renderer.add_rays(*stats);
  }
  return renderer.status();
}

RenderStatus render_pass(const TraceScene& traced, const RenderScene& scene,
                         const RenderOptions& options, Film& film, const Progress& progress,
                         RenderStats* stats) {
  const ThreadLimit limit(options.threads);
  return render_pass(Tracer(traced, scene, options), film, progress, stats);
}

}  // namespace scenefile
