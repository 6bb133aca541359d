#pragma once
// The samples of many pixels, taken in waves.

#include "scenefile/trace/fine_samples.h"
#include "scenefile/trace/wave.h"

#include <array>
#include <mutex>
#include <span>
#include <vector>

namespace scenefile {

/// The memory of waves that no thread uses now.
class WavePool {
 public:
  WavePointer take();
  void give(WavePointer wave);

 private:
  std::mutex mutex_;
  std::vector<WavePointer> free_;
};

/// A pixel with its samples so far.
struct WavePixel {
  glm::ivec2 at{0};
  PixelSamples samples;
};

/// Waves of one thread for one piece of a picture.
class WaveSampler {
 public:
  WaveSampler(const WaveScene& scene, WavePool& pool, RayCounts& counts);
  ~WaveSampler();
  WaveSampler(const WaveSampler&) = delete;
  WaveSampler& operator=(const WaveSampler&) = delete;

  /// What is seen in the middles of pixels, at most wave_samples, in the order of `pixels`; until
  /// the next call.
  std::span<const WaveSight> middles(std::span<const glm::ivec2> pixels);
  /// FineSampler::take() of the first samples of each pixel.
  std::vector<WavePixel> take(const FineSampler& sampler, std::span<const glm::ivec2> pixels);
  /// The same, and refine().
  std::vector<WavePixel> refine(const FineSampler& sampler, std::span<const glm::ivec2> pixels);

 private:
  void take(const FineSampler& sampler, const std::vector<WavePixel*>& pixels, std::uint32_t count);
  void add(WavePixel& pixel, const CameraSample& sample);
  void finish();
  std::span<const WaveSight> trace();

  const WaveScene& scene_;
  WavePool& pool_;
  RayCounts& counts_;
  WavePointer memory_;
  std::vector<CameraSample> samples_;  // of the next wave
  std::vector<WavePixel*> owners_;     // of those
  std::array<WaveSight, wave_samples> sights_;
};

}  // namespace scenefile
