#include "scenefile/trace/preview_picture.h"

#include "scenefile/trace/pixel_sampler.h"
#include "scenefile/trace/tiles.h"

#include <algorithm>
#include <array>
#include <utility>

namespace scenefile {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int block = 8;

}  // namespace

PreviewPicture::PreviewPicture(const Preview& preview, const Film& film)
    : preview_(preview), film_(film) {
  if (wanted()) {
    shown_ = Image(film.region.width(), film.region.height());
  }
}

void PreviewPicture::start(const Tracer& tracer) {
  const CameraRays camera = tracer.camera();
  const WavefrontScene scene(tracer, camera);
  WavefrontPool pool;
  for_each_line((shown_.height + block - 1) / block, [&](int row) {
    WavefrontPointer memory = pool.take();
    for (int x = 0; x < shown_.width; x += block * wavefront_samples) {
      start_blocks(scene, x, row * block, *memory);
    }
    pool.give(std::move(memory));
  });
  show();
}

// The blocks of a line from x0 on, as many as a wavefront has samples.
void PreviewPicture::start_blocks(const WavefrontScene& scene, int x0, int y0,
                                  WavefrontMemory& memory) {
  std::array<CameraSample, wavefront_samples> samples;
  std::array<SampleResult, wavefront_samples> results;
  const int count = std::min(wavefront_samples, (shown_.width - x0 + block - 1) / block);
  for (int i = 0; i < count; ++i) {
    const glm::dvec2 corner(film_.region.x0 + x0 + i * block, film_.region.y0 + y0);
    samples[static_cast<std::size_t>(i)] = {corner + block / 2.0, {}, block, {}};
  }
  RayCounts counts;
  trace_wavefront(scene, samples.data(), count, memory, results.data(), counts);
  for (int i = 0; i < count; ++i) {
    fill(x0 + i * block, y0, results[static_cast<std::size_t>(i)].color);
  }
}

void PreviewPicture::show_in_time() {
  const std::chrono::duration<double> since = Clock::now() - last_;
  if (since.count() >= preview_.interval_seconds) {
    update();
    show();
  }
}

void PreviewPicture::fill(int x0, int y0, const Color& color) {
  for (int y = y0; y < std::min(y0 + block, shown_.height); ++y) {
    for (int x = x0; x < std::min(x0 + block, shown_.width); ++x) {
      for (int c = 0; c < 3; ++c) {
        shown_.pixel(x, y)[c] = static_cast<float>(color[c]);
      }
    }
  }
}

void PreviewPicture::show() {
  preview_.show(cut(shown_, film_.region, film_.crop));
  last_ = Clock::now();
}

}  // namespace scenefile
