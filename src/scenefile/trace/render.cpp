#include "scenefile/trace/render.h"

#include "scenefile/trace/course_samples.h"
#include "scenefile/trace/fine_samples.h"
#include "scenefile/trace/tiles.h"

#include <algorithm>
#include <atomic>
#include <chrono>

namespace scenefile {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

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

class Renderer {
 public:
  Renderer(const Tracer& tracer, const Progress& progress, RenderResult& result)
      : tracer_(tracer), camera_(tracer.camera()), watch_(progress), result_(result) {}

  void run() {
    if (tracer_.course()) {
      run_course();
    } else {
      run_fine();
    }
    result_.stats.primary_rays = counts_.primary;
    result_.stats.shadow_rays = counts_.shadow;
    result_.stats.secondary_rays = counts_.secondary;
    if (tracer_.accelerator.overwhelmed()) {
      result_.status = RenderStatus::limit_reached;
    } else if (watch_.stopped()) {
      result_.status = RenderStatus::cancelled;
    }
  }

 private:
  // Calls pixel(x, y, counts) for all pixels.
  template <typename F>
  void for_each_pixel(PassShare share, const F& pixel) {
    const RenderOptions& options = tracer_.options;
    for_each_row(options.width, options.height, share, watch_, [&](const Tile& tile) {
      RayCounts counts;
      for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1 && !given_up(); ++x) {
          pixel(x, y, counts);
        }
      }
      counts_.add(counts);
    });
  }

  bool given_up() const { return watch_.stopped() || tracer_.accelerator.overwhelmed(); }

  void put(int x, int y, const Color& color) {
    float* const pixel = result_.image.pixel(x, y);
    for (int c = 0; c < 3; ++c) {
      pixel[c] = static_cast<float>(color[c]);
    }
  }

  Color get(int x, int y) const {
    const float* const pixel = result_.image.pixel(x, y);
    return {pixel[0], pixel[1], pixel[2]};
  }

  void run_course() {
    for_each_pixel({0, 1}, [&](int x, int y, RayCounts& counts) {
      put(x, y, course_pixel(tracer_, camera_, x, y, counts));
    });
  }

  void run_fine() {
    const FineSampler sampler(tracer_, camera_);
    const RenderOptions& options = tracer_.options;
    const std::uint32_t first = sampler.first_samples();
    const bool more = static_cast<std::uint32_t>(options.samples) > first;
    std::vector<std::uint8_t> coarse(std::size_t(options.width) * options.height, 0);
    const auto index = [&](int x, int y) { return std::size_t(y) * options.width + x; };
    for_each_pixel({0, more ? 0.4 : 1.0}, [&](int x, int y, RayCounts& counts) {
      PixelSamples samples;
      sampler.take(x, y, first, samples, counts);
      put(x, y, samples.mean());
      coarse[index(x, y)] = !settled(samples);
    });
    if (!more || given_up()) {
      return;
    }
    mark_edges(coarse);
    for_each_pixel({0.4, 1}, [&](int x, int y, RayCounts& counts) {
      if (coarse[index(x, y)] != 0) {
        PixelSamples samples;
        sampler.take(x, y, first, samples, counts);
        sampler.refine(x, y, samples, counts);
        put(x, y, samples.mean());
      }
    });
  }

  // Neighbors that differ both need more samples.
  void mark_edges(std::vector<std::uint8_t>& coarse) const {
    const int width = tracer_.options.width;
    const int height = tracer_.options.height;
    constexpr int steps[4][2] = {{1, 0}, {-1, 1}, {0, 1}, {1, 1}};
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        for (const auto& [dx, dy] : steps) {
          const int x1 = x + dx;
          const int y1 = y + dy;
          if (x1 >= 0 && x1 < width && y1 < height && differ(get(x, y), get(x1, y1))) {
            coarse[std::size_t(y) * width + x] = 1;
            coarse[std::size_t(y1) * width + x1] = 1;
          }
        }
      }
    }
  }

  const Tracer& tracer_;
  CameraRays camera_;
  Watch watch_;
  RenderResult& result_;
  SharedCounts counts_;
};

}  // namespace

RenderResult render(const RenderScene& scene, const Assets& assets, const RenderOptions& options,
                    const Progress& progress) {
  RenderResult result;
  const ThreadLimit limit(options.threads);
  const Clock::time_point start = Clock::now();
  const Tracer tracer(scene, assets, options);
  result.stats.build_seconds = seconds_since(start);
  result.status = tracer.status();
  result.image = Image(tracer.options.width, tracer.options.height);
  if (result.status != RenderStatus::complete) {
    return result;
  }
  const Clock::time_point built = Clock::now();
  Renderer(tracer, progress, result).run();
  result.stats.trace_seconds = seconds_since(built);
  return result;
}

}  // namespace scenefile
