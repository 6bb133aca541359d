#include "scenefile/trace/render_pass.h"

#include "scenefile/trace/edges.h"
#include "scenefile/trace/layer_buffers.h"
#include "scenefile/trace/tiles.h"
#include "scenefile/trace/wave_pixels.h"

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
  Renderer(const Tracer& tracer, const Progress& progress, PictureState& picture)
      : tracer_(tracer),
        camera_(tracer.camera()),
        region_(picture.region),
        watch_(progress),
        picture_(picture),
        layers_(tracer, camera_, picture),
        wish_{!layers_.empty() || !picture.statistics.empty(), layers_.lights(),
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
    return watch_.stopped() ? RenderStatus::cancelled : RenderStatus::complete;
  }

  void add_rays(RenderStats& stats) const {
    stats.primary_rays += counts_.primary;
    stats.shadow_rays += counts_.shadow;
    stats.secondary_rays += counts_.secondary;
  }

 private:
  bool given_up() const { return watch_.stopped() || tracer_.accelerator.overwhelmed(); }

  // Calls draw(pixels, counts) for each piece.
  template <typename F>
  void for_each_tile(PassShare share, const F& draw) {
    for_each_piece(picture_.pieces, share, watch_, [&](const Tile& tile) {
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

  // Calls draw(sampler, pixels) for each piece, with a sampler for each thread.
  template <typename F>
  void for_each_sampler(PassShare share, const F& draw) {
    const WaveScene scene(tracer_, camera_);
    WavePool pool;
    for_each_tile(share, [&](std::vector<glm::ivec2>& pixels, RayCounts& counts) {
      WaveSampler waves(scene, pool, wish_, counts);
      draw(waves, pixels);
    });
  }

  void run_course() {
    const bool one_sample = !camera_.has_lens() && !tracer_.options.features.super_sample;
    for_each_sampler({0, 1}, [&](WaveSampler& sampler, const std::vector<glm::ivec2>& pixels) {
      if (one_sample && !wish_.wanted) {
        put_sights(pixels, sampler.middles(pixels));
        return;
      }
      for (const DrawnPixel& pixel : sampler.course(pixels)) {
        put(pixel.at, pixel.color);
        keep(pixel);
      }
    });
  }

  void run_fine() {
    const FineSampler sampler(tracer_, camera_);
    const SamplePlan& plan = sampler.plan();
    const double first_share = !plan.two_passes ? 1.0 : plan.middles ? 0.4 : 0.9;
    if (picture_.pass == 0 && !picture_.pieces.all_done()) {
      plan.middles ? take_middles(sampler, first_share) : take_all(sampler, first_share);
      return;
    }
    if (picture_.pass == 0) {
      mark_uneven(sampler);
      picture_.pass = 1;
      picture_.pieces.restart();
    }
    watch_.count(first_share);
    take_marked(sampler, first_share);
  }

  void take_middles(const FineSampler& fine, double share) {
    for_each_sampler({0, share}, [&](WaveSampler& sampler, const std::vector<glm::ivec2>& pixels) {
      if (!wish_.wanted) {
        put_sights(pixels, sampler.middles(fine, pixels));
        return;
      }
      for (const DrawnPixel& pixel : sampler.take_middles(fine, pixels)) {
        put(pixel.at, pixel.samples.mean());
        keep(pixel);
        mark(pixel.at, pixel.signature);
      }
    });
  }

  void take_all(const FineSampler& fine, double share) {
    for_each_sampler({0, share}, [&](WaveSampler& sampler, const std::vector<glm::ivec2>& pixels) {
      const std::vector<std::uint16_t> marks(pixels.size());
      const std::vector<DrawnPixel> taken = sampler.take(fine, pixels, marks);
      put_pixels(taken);
      for (const DrawnPixel& pixel : taken) {
        mark(pixel.at, pixel.samples.count < fine.plan().most ? 1 : 0);
      }
    });
  }

  void take_marked(const FineSampler& fine, double from) {
    for_each_sampler({from, 1}, [&](WaveSampler& sampler, std::vector<glm::ivec2>& pixels) {
      std::erase_if(pixels, [&](const glm::ivec2& at) { return !marked(at); });
      std::vector<std::uint16_t> marks;
      for (const glm::ivec2& at : pixels) {
        marks.push_back(picture_.marked[index(at)]);
      }
      put_pixels(sampler.take(fine, pixels, marks));
    });
  }

  void put_pixels(const std::vector<DrawnPixel>& pixels) {
    for (const DrawnPixel& pixel : pixels) {
      put(pixel.at, pixel.samples.mean());
      keep(pixel);
    }
  }

  // The common case, with minimal work per pixel.
  void put_sights(const std::vector<glm::ivec2>& pixels, std::span<const WaveSight> sights) {
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      put(pixels[i], sights[i].color);
      mark(pixels[i], sights[i].signature);
    }
  }

  void mark(const glm::ivec2& at, std::uint32_t signature) {
    if (!picture_.marked.empty()) {
      picture_.marked[index(at)] = kept_signature(signature);
    }
  }

  // Whether the pixel needs more samples.
  bool marked(const glm::ivec2& at) const {
    const PixelRegion& own = picture_.own;
    return at.x >= own.x0 && at.x < own.x1 && at.y >= own.y0 && at.y < own.y1 &&
           picture_.marked[index(at)] != 0;
  }

  // Converts the notes of the first pass to marks: how much each pixel must be refined.
  void mark_uneven(const FineSampler& fine) {
    const std::vector<std::uint16_t> noted = picture_.marked;
    for_each_row_of_contrasts(picture_.image, noted, [&](int y, const RowOfContrasts& contrasts) {
      std::uint16_t* const marks = &picture_.marked[std::size_t(y) * contrasts.most.size()];
      for (std::size_t x = 0; x < contrasts.most.size(); ++x) {
        const bool has_all = !fine.plan().middles && marks[x] == 0;
        marks[x] = has_all ? 0 : fine.mark_of({contrasts.most[x], contrasts.edges[x]});
      }
    });
  }

  // Stores the recorded data of a pixel.
  void keep(const DrawnPixel& pixel) {
    if (!layers_.empty()) {
      layers_.put(pixel.at.x, pixel.at.y, pixel.surfaces);
    }
    if (!picture_.statistics.empty()) {
      picture_.statistics[index(pixel.at)] = statistics_of(pixel.surfaces.samples, picture_.sharp);
    }
  }

  void put(const glm::ivec2& at, const Color& color) {
    float* const pixel = &picture_.image.rgb[3 * index(at)];
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
  Watch watch_;
  PictureState& picture_;
  LayerBuffers layers_;
  SurfaceWish wish_;
  SharedCounts counts_;
};

}  // namespace

RenderStatus render_pass(const Tracer& tracer, PictureState& state, const Progress& progress,
                         RenderStats* stats) {
  if (tracer.status() != RenderStatus::complete || complete(state)) {
    return tracer.status();
  }
  Renderer renderer(tracer, progress, state);
  renderer.run();
  if (stats != nullptr) {
    renderer.add_rays(*stats);
  }
  return renderer.status();
}

RenderStatus render_pass(const TraceScene& traced, const RenderScene& scene,
                         const RenderOptions& options, PictureState& state,
                         const Progress& progress, RenderStats* stats) {
  const ThreadLimit limit(options.threads);
  return render_pass(Tracer(traced, scene, options), state, progress, stats);
}

}  // namespace scenefile
