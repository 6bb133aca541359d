#include "scenefile/path/progressive.h"

#include "scenefile/path/path_scene.h"
#include "scenefile/path/path_state.h"
#include "scenefile/path/tone.h"
#include "scenefile/trace/tasks.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace scenefile {

namespace {

using PassClock = std::chrono::steady_clock;

double pass_seconds(PassClock::time_point start) {
  return std::chrono::duration<double>(PassClock::now() - start).count();
}

// So that the first picture is there after about 0.1 s.
int first_stride(std::size_t pixels, double rate) {
  constexpr double seconds = 0.1;
  constexpr double unknown_rate = 50'000;
  const double affordable = seconds * (rate > 0 ? rate : unknown_rate);
  int stride = 1;
  while (stride < 32 && double(pixels) / (stride * stride) > affordable) {
    stride *= 2;
  }
  return stride;
}

Image every_nth_pixel(const Image& all, int n) {
  Image some((all.width + n - 1) / n, (all.height + n - 1) / n);
  float* to = some.rgb.data();
  for (int y = 0; y < all.height; y += n) {
    for (int x = 0; x < all.width; x += n) {
      to = std::copy_n(&all.rgb[3 * (std::size_t(y) * all.width + x)], 3, to);
    }
  }
  return some;
}

double noise_of(const Image& image, const std::vector<float>& variances) {
  const double white = brightest(image.rgb, 0);
  double errors = 0;
  for (std::size_t i = 0; i < variances.size(); ++i) {
    const float* const c = &image.rgb[3 * i];
    const double bright = luminance({c[0], c[1], c[2]});
    const double error = std::sqrt(double(variances[i]));
    errors += (course_tone(bright + error, white) - course_tone(bright - error, white)) / 2;
  }
  return errors / double(variances.size());
}

class PathProgress {
 public:
  PathProgress(const PathScene& scene, PathPasses& passes)
      : scene_(scene), passes_(passes), state_(make_path_state(scene.options)) {}

  RenderStatus run() {
    RenderStatus status = RenderStatus::complete;
    for (int stride = first_stride(state_.sums.size(), passes_.rate);
         stride > 1 && status == RenderStatus::complete; stride /= 2) {
      status = add(1, stride);
    }
    const auto most = std::uint32_t(scene_.options.samples);
    while (status == RenderStatus::complete && !complete_) {
      const double seconds = std::clamp(pass_seconds(start_) / 4, 0.2, 1.0);
      const double more = seconds * passes_.rate / double(state_.sums.size());
      const std::uint32_t target =
          samples_ == 0 ? 1 : samples_ + std::uint32_t(std::clamp(more, 1.0, double(samples_)));
      status = add(std::min(target, most), 1);
    }
    return status;
  }

 private:
  // Takes and shows the samples that pixels have less than `target`.
  RenderStatus add(std::uint32_t target, int stride) {
    const PassClock::time_point begun = PassClock::now();
    const std::uint64_t before = stats_.primary_rays;
    const RenderStatus status = add_samples(
        scene_, target, state_, [&](double) { return passes_.go_on(first_); }, stats_, stride);
    if (status != RenderStatus::complete) {
      return status;
    }
    passes_.rate = double(stats_.primary_rays - before) / std::max(1e-6, pass_seconds(begun));
    samples_ = stride == 1 ? target : 0;
    PathPass pass;
    pass.image = stride == 1 ? image_of(state_) : every_nth_pixel(image_of(state_), stride);
    pass.samples = samples_;
    pass.noise = samples_ > 1 ? noise_of(pass.image, variances_of(state_)) : 0;
    // Fewer samples say little about the noise.
    constexpr std::uint32_t fewest = 16;
    complete_ = stride == 1 && (target == std::uint32_t(scene_.options.samples) ||
                                (target >= fewest && pass.noise <= passes_.noise));
    pass.complete = complete_;
    first_ = false;
    passes_.show(std::move(pass));
    return status;
  }

  const PathScene& scene_;
  PathPasses& passes_;
  PathState state_;
  RenderStats stats_;
  PassClock::time_point start_ = PassClock::now();
  std::uint32_t samples_ = 0;
  bool first_ = true;
  bool complete_ = false;
};

}  // namespace

RenderStatus render_progressively(const TraceScene& traced, const RenderScene& scene,
                                  const RenderOptions& options, PathPasses& passes) {
  if (traced.status() != RenderStatus::complete) {
    return traced.status();
  }
  const ThreadLimit limit(options.threads);
  RenderOptions plain = options;
  plain.denoise = false;
  plain.layers.clear();
  return PathProgress(PathScene(traced, scene, plain), passes).run();
}

}  // namespace scenefile
