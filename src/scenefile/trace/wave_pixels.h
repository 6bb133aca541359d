#pragma once
// The samples of many pixels, taken in waves.

#include "scenefile/trace/drawn_pixel.h"
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

/// Waves of one thread for one piece of a picture.
class WaveSampler {
 public:
  WaveSampler(const WaveScene& scene, WavePool& pool, const SurfaceWish& wish, RayCounts& counts);
  ~WaveSampler();
  WaveSampler(const WaveSampler&) = delete;
  WaveSampler& operator=(const WaveSampler&) = delete;

  /// What is seen in the middles of pixels, at most wave_samples, in the order of `pixels`; until
  /// the next call. Not recorded.
  std::span<const WaveSight> middles(std::span<const glm::ivec2> pixels);
  /// course_pixel() of each.
  std::vector<DrawnPixel> course(std::span<const glm::ivec2> pixels);
  /// FineSampler::take() of the first samples of each pixel.
  std::vector<DrawnPixel> take(const FineSampler& sampler, std::span<const glm::ivec2> pixels);
  /// The same, and refine().
  std::vector<DrawnPixel> refine(const FineSampler& sampler, std::span<const glm::ivec2> pixels);

 private:
  template <typename SampleOf, typename Keep>
  void trace(std::size_t count, const SampleOf& sample_of, const Keep& keep);
  void trace(int count, bool recorded);
  void add_surface(int index, PixelSurfaces& surfaces) const;
  void take(const FineSampler& sampler, const std::vector<DrawnPixel*>& pixels,
            std::uint32_t count);
  void lens_pixels(std::vector<DrawnPixel>& pixels);
  void cell_pixels(std::vector<DrawnPixel>& pixels);

  const WaveScene& scene_;
  WavePool& pool_;
  const SurfaceWish& wish_;
  RayCounts& counts_;
  WavePointer memory_;
  std::array<CameraSample, wave_samples> samples_;
  std::array<WaveSight, wave_samples> sights_;
  std::vector<SurfaceSample> surfaces_;  // by sample, where they are wished for
  std::vector<Color> light_colors_;      // by sample and light
};

}  // namespace scenefile
