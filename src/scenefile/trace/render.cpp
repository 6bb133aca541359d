#include "scenefile/trace/render.h"

#include "scenefile/trace/course_samples.h"
#include "scenefile/trace/fine_samples.h"
#include "scenefile/trace/layer_buffers.h"
#include "scenefile/trace/picture_state.h"
#include "scenefile/trace/preview_picture.h"
#include "scenefile/trace/tiles.h"
#include "scenefile/trace/wave_pixels.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <span>
#include <utility>

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

bool has_two_passes(const RenderOptions& options) {
  return options.profile == Profile::fine &&
         static_cast<std::uint32_t>(options.samples) > FineSampler::first_samples(options);
}

// Progress that also saves the state when it is time.
class SavingProgress {
 public:
  SavingProgress(const Progress& progress, const Checkpoints& checkpoints,
                 const PictureState& picture)
      : progress_(progress), checkpoints_(checkpoints), picture_(picture) {}

  bool operator()(double done) {
    const bool go_on = !progress_ || progress_(done);
    if (!go_on || seconds_since(saved_) >= checkpoints_.interval_seconds) {
      checkpoints_.save(picture_.bytes());
      saved_ = Clock::now();
    }
    return go_on;
  }

 private:
  const Progress& progress_;
  const Checkpoints& checkpoints_;
  const PictureState& picture_;
  Clock::time_point saved_ = Clock::now();
};

PixelRegion grown(const PixelRegion& region, int by, const RenderOptions& options) {
  return {std::max(0, region.x0 - by), std::max(0, region.y0 - by),
          std::min(options.width, region.x1 + by), std::min(options.height, region.y1 + by)};
}

PixelRegion crop_of(const RenderOptions& options) {
  return options.crop.value_or(PixelRegion{0, 0, options.width, options.height});
}

// All pixels that those of the crop depend on.
PixelRegion region_of(const RenderOptions& options) {
  const int neighbors = has_two_passes(options) ? 1 : 0;
  return grown(crop_of(options), neighbors + (options.denoise ? denoise_reach : 0), options);
}

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

// Draws the region of the picture. Coordinates are those of the picture.
class Renderer {
 public:
  Renderer(const Tracer& tracer, const PixelRegion& region, const Progress& progress,
           PictureState& picture, PreviewPicture& preview, RenderResult& result)
      : tracer_(tracer),
        camera_(tracer.camera()),
        region_(region),
        watch_(progress),
        picture_(picture),
        preview_(preview),
        result_(result),
        layers_(tracer, camera_, region) {
    if (tracer.options.denoise && has_noise()) {
      statistics_.resize(std::size_t(region.width()) * region.height());
    }
  }

  void run() {
    if (preview_.wanted() && picture_.pass == 0) {
      preview_.start(tracer_, camera_);
    }
    if (tracer_.course()) {
      run_course();
    } else {
      run_fine();
    }
    finish();
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
  bool has_noise() const {
    const std::vector<RenderLight>& lights = tracer_.scene.lights;
    const auto is_area = [](const RenderLight& light) { return light.type == LightType::area; };
    return !tracer_.course() &&
           (camera_.has_lens() || std::any_of(lights.begin(), lights.end(), is_area));
  }

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

  bool records() const { return !layers_.empty() || !statistics_.empty(); }

  // What was recorded of a pixel; nothing where the pass left it as it was.
  void keep(int x, int y, const SurfaceRecorder& recorder) {
    if (recorder.samples().empty()) {
      return;
    }
    if (!layers_.empty()) {
      layers_.put(x, y, recorder);
    }
    if (!statistics_.empty()) {
      statistics_[index(x, y)] = statistics_of(recorder.samples(), !camera_.has_lens());
    }
  }

  void finish() {
    const PixelRegion crop = crop_of(tracer_.options);
    if (!statistics_.empty() && !given_up()) {
      const std::vector<glm::vec3> colors =
          denoised(region_.width(), region_.height(), statistics_, !camera_.has_lens());
      for (std::size_t i = 0; i < colors.size(); ++i) {
        std::copy_n(&colors[i].x, 3, &picture_.image.rgb[3 * i]);
      }
    }
    result_.image =
        crop == region_ ? std::move(picture_.image) : cut(picture_.image, region_, crop);
    result_.layers = layers_.cut(crop);
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
    if (picture_.pass == 0) {
      sample_all(sampler, first_share);
      if (!two_passes || given_up()) {
        return;
      }
      mark_edges();
      if (preview_.wanted()) {
        preview_.update();
      }
      picture_.start_second_pass();
    }
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

  bool marked(int x, int y) const { return picture_.marked[index(x, y)] != 0; }

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
  PreviewPicture& preview_;
  RenderResult& result_;
  LayerBuffers layers_;
  std::vector<PixelStatistics> statistics_;  // by pixel of the region, where noise is taken away
  SharedCounts counts_;
};

// `spare`: what may be given back once the acceleration structure stands.
RenderResult render_scene(const RenderScene& scene, std::vector<RenderGroup>* spare,
                          const Assets& assets, const RenderOptions& options,
                          const Progress& progress, const Checkpoints& checkpoints,
                          const Preview& preview, Image canvas) {
  RenderResult result;
  const ThreadLimit limit(options.threads);
  const Clock::time_point start = Clock::now();
  const Tracer tracer(scene, assets, options);
  if (spare != nullptr) {
    std::vector<RenderGroup>().swap(*spare);
  }
  result.stats.build_seconds = seconds_since(start);
  result.status = tracer.status();
  const PixelRegion crop = crop_of(tracer.options);
  const PixelRegion region = region_of(tracer.options);
  PictureState picture(region.width(), region.height(), has_two_passes(tracer.options),
                       std::move(canvas));
  if (!checkpoints.resume.empty() && !picture.restore(checkpoints.resume)) {
    result.status = RenderStatus::not_resumed;
  }
  if (result.status != RenderStatus::complete) {
    result.image = Image(crop.width(), crop.height());
    return result;
  }
  const Clock::time_point built = Clock::now();
  PreviewPicture shown(preview, picture, region, crop);
  const Progress saving =
      checkpoints.save ? Progress(SavingProgress(progress, checkpoints, picture)) : progress;
  const Progress showing = [&](double done) {
    shown.show_in_time();
    return !saving || saving(done);
  };
  Renderer(tracer, region, shown.wanted() ? showing : saving, picture, shown, result).run();
  if (shown.wanted()) {
    preview.show(result.image);
  }
  result.stats.trace_seconds = seconds_since(built);
  return result;
}

}  // namespace

RenderResult render(const RenderScene& scene, const Assets& assets, const RenderOptions& options,
                    const Progress& progress, const Checkpoints& checkpoints,
                    const Preview& preview, Image canvas) {
  return render_scene(scene, nullptr, assets, options, progress, checkpoints, preview,
                      std::move(canvas));
}

RenderResult render(RenderScene&& scene, const Assets& assets, const RenderOptions& options,
                    const Progress& progress, const Checkpoints& checkpoints,
                    const Preview& preview, Image canvas) {
  return render_scene(scene, &scene.groups, assets, options, progress, checkpoints, preview,
                      std::move(canvas));
}

}  // namespace scenefile
