#include "scenefile/trace/render_pass.h"

#include "scenefile/trace/course_samples.h"
#include "scenefile/trace/fine_samples.h"
#include "scenefile/trace/layer_buffers.h"
#include "scenefile/trace/tiles.h"
#include "scenefile/trace/wave_pixels.h"

#include <algorithm>
#include <atomic>
#include <span>
#include <utility>

namespace scenefile {

namespace {

// Rays of all threads.
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

// Calls f(x, y) for the pixels of a tile such that those called one after the other are near each
// other: blocks of 4 x 2.
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

// Draws one pass. Coordinates are those of the picture.
class Renderer {
 public:
  Renderer(const Tracer& tracer, const Progress& progress, PictureState& picture)
      : tracer_(tracer),
        camera_(tracer.camera()),
        region_(picture.region),
        watch_(progress),
        picture_(picture),
        layers_(tracer, camera_, picture) {}

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
  // Calls pixel(x, y, counts) for all pixels.
  template <typename F>
  void for_each_pixel(PassShare share, const F& pixel) {
    for_each_piece(picture_.pieces, share, watch_, [&](const Tile& tile) {
      RayCounts counts;
      SurfaceRecorder recorder(tracer_.scene, layers_.lights());
      counts.recorder = records() ? &recorder : nullptr;
      for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1 && !given_up(); ++x) {
          recorder.clear();
          pixel(x + region_.x0, y + region_.y0, counts);
          keep(x + region_.x0, y + region_.y0, recorder);
        }
      }
      counts_.add(counts);
      return !given_up();
    });
  }

  bool records() const { return !layers_.empty() || !picture_.statistics.empty(); }

  // What was recorded of a pixel; nothing where the pass left it as it was.
  void keep(int x, int y, const SurfaceRecorder& recorder) {
    if (recorder.samples().empty()) {
      return;
    }
    if (!layers_.empty()) {
      layers_.put(x, y, recorder);
    }
    if (!picture_.statistics.empty()) {
      picture_.statistics[index(x, y)] = statistics_of(recorder.samples(), picture_.sharp);
    }
  }

  bool given_up() const { return watch_.stopped() || tracer_.accelerator.overwhelmed(); }

  void put(int x, int y, const Color& color) {
    float* const pixel = &picture_.image.rgb[3 * index(x, y)];
    for (int c = 0; c < 3; ++c) {
      pixel[c] = static_cast<float>(color[c]);
    }
  }

  Color get(int x, int y) const {
    const float* const pixel = &picture_.image.rgb[3 * index(x, y)];
    return {pixel[0], pixel[1], pixel[2]};
  }

  bool in_waves() const { return !records() && takes_waves(tracer_, camera_); }

  void run_course() {
    if (!tracer_.options.features.super_sample && in_waves()) {
      for_each_wave({0, 1}, [&](WaveSampler& waves, const std::vector<glm::ivec2>& pixels) {
        const std::span<const WaveSight> sights = waves.middles(pixels);
        for (std::size_t i = 0; i < pixels.size(); ++i) {
          put(pixels[i].x, pixels[i].y, sights[i].color);
        }
      });
      return;
    }
    for_each_pixel({0, 1}, [&](int x, int y, RayCounts& counts) {
      put(x, y, course_pixel(tracer_, camera_, x, y, counts));
    });
  }

  // Calls draw(waves, pixels) for the pixels of each piece.
  template <typename F>
  void for_each_wave(PassShare share, const F& draw) {
    const WaveScene scene(tracer_, camera_);
    WavePool pool;
    for_each_piece(picture_.pieces, share, watch_, [&](const Tile& tile) {
      RayCounts counts;
      WaveSampler waves(scene, pool, counts);
      std::vector<glm::ivec2> pixels;
      pixels.reserve(std::size_t{tile_side} * tile_side);
      for_each_in_blocks(
          tile, [&](int x, int y) { pixels.emplace_back(x + region_.x0, y + region_.y0); });
      draw(waves, pixels);
      counts_.add(counts);
      return !given_up();
    });
  }

  void run_fine() {
    const FineSampler sampler(tracer_, camera_);
    const bool two_passes = !picture_.marked.empty();
    const double first_share = two_passes ? 0.4 : 1.0;
    if (picture_.pass == 0 && !picture_.pieces.all_done()) {
      sample_all(sampler, first_share);
      return;
    }
    if (picture_.pass == 0) {
      mark_edges();
      picture_.pass = 1;
      picture_.pieces.restart();
    }
    watch_.count(first_share);
    refine_marked(sampler, first_share);
  }

  void put_first(int x, int y, const PixelSamples& samples) {
    put(x, y, samples.mean());
    if (!picture_.marked.empty()) {
      picture_.marked[index(x, y)] = !settled(samples);
    }
  }

  void sample_all(const FineSampler& sampler, double share) {
    if (in_waves()) {
      for_each_wave({0, share}, [&](WaveSampler& waves, const std::vector<glm::ivec2>& pixels) {
        for (const auto& [at, samples] : waves.take(sampler, pixels)) {
          put_first(at.x, at.y, samples);
        }
      });
      return;
    }
    for_each_pixel({0, share}, [&](int x, int y, RayCounts& counts) {
      PixelSamples samples;
      sampler.take(x, y, sampler.first_samples(), samples, counts);
      put_first(x, y, samples);
    });
  }

  // Whether the pixel needs more samples.
  bool marked(int x, int y) const {
    const PixelRegion& own = picture_.own;
    return x >= own.x0 && x < own.x1 && y >= own.y0 && y < own.y1 &&
           picture_.marked[index(x, y)] != 0;
  }

  void refine_marked(const FineSampler& sampler, double from) {
    if (in_waves()) {
      for_each_wave({from, 1}, [&](WaveSampler& waves, std::vector<glm::ivec2>& pixels) {
        std::erase_if(pixels, [&](const glm::ivec2& at) { return !marked(at.x, at.y); });
        for (const auto& [at, samples] : waves.refine(sampler, pixels)) {
          put(at.x, at.y, samples.mean());
        }
      });
      return;
    }
    for_each_pixel({from, 1}, [&](int x, int y, RayCounts& counts) {
      if (marked(x, y)) {
        PixelSamples samples;
        sampler.take(x, y, sampler.first_samples(), samples, counts);
        sampler.refine(x, y, samples, counts);
        put(x, y, samples.mean());
      }
    });
  }

  // Neighbors that differ both need more samples.
  void mark_edges() {
    constexpr int steps[4][2] = {{1, 0}, {-1, 1}, {0, 1}, {1, 1}};
    for (int y = region_.y0; y < region_.y1; ++y) {
      for (int x = region_.x0; x < region_.x1; ++x) {
        for (const auto& [dx, dy] : steps) {
          const int x1 = x + dx;
          const int y1 = y + dy;
          if (x1 >= region_.x0 && x1 < region_.x1 && y1 < region_.y1 &&
              differ(get(x, y), get(x1, y1))) {
            picture_.marked[index(x, y)] = 1;
            picture_.marked[index(x1, y1)] = 1;
          }
        }
      }
    }
  }

  std::size_t index(int x, int y) const {
    return std::size_t(y - region_.y0) * region_.width() + (x - region_.x0);
  }

  const Tracer& tracer_;
  CameraRays camera_;
  PixelRegion region_;
  Watch watch_;
  PictureState& picture_;
  LayerBuffers layers_;
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
