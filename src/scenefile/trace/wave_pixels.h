#pragma once
// Samples pixels in waves.

#include "scenefile/trace/fine_samples.h"
#include "scenefile/trace/surface_sample.h"
#include "scenefile/trace/wave_memory.h"

#include <cstddef>
#include <mutex>
#include <span>
#include <vector>

namespace scenefile {

/// A pixel with its samples.
struct DrawnPixel {
  glm::ivec2 at{0};
  Color color{0};               ///< of the course profile
  PixelSamples samples;         ///< of the fine profile
  std::uint32_t signature = 0;  ///< of the last sample; only set by waves
  PixelSurfaces surfaces;       ///< if requested
};

/// Which surface data of camera rays to record.
struct SurfaceWish {
  bool wanted = false;
  std::vector<std::uint32_t> lights;  ///< lights to record separately, into RenderScene::lights
  bool centers = false;               ///< also the surface at the center of each pixel
};

inline std::vector<DrawnPixel> pixels_at(std::span<const glm::ivec2> places) {
  std::vector<DrawnPixel> pixels(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    pixels[i].at = places[i];
  }
  return pixels;
}

/// Wave memory that is not in use by any thread.
class WavePool {
 public:
  WavePointer take();
  /// A wave that take() returned. Destructors call it, so there is room for it.
  void give(WavePointer wave) noexcept;

 private:
  std::mutex mutex_;
  std::size_t made_ = 0;  // all waves, free or not
  std::vector<WavePointer> free_;
};

/// The waves of one thread for one piece of a picture.
class WaveSampler {
 public:
  WaveSampler(const WaveScene& scene, WavePool& pool, const SurfaceWish& wish, RayCounts& counts);
  ~WaveSampler();
  WaveSampler(const WaveSampler&) = delete;
  WaveSampler& operator=(const WaveSampler&) = delete;

  /// The centers of at most wave_samples pixels, in the order of `pixels`; valid until the next
  /// call. Not recorded.
  std::span<const WaveSight> middles(std::span<const glm::ivec2> pixels);
  /// The samples of the course profile: one at the center, the adaptive cell, or the lens samples.
  std::vector<DrawnPixel> course(std::span<const glm::ivec2> pixels);
  /// FineSampler::middle() of at most wave_samples pixels, in the order of `pixels`; valid until
  /// the next call. Not recorded.
  std::span<const WaveSight> middles(const FineSampler& sampler,
                                     std::span<const glm::ivec2> pixels);
  /// One recorded center sample of each pixel.
  std::vector<DrawnPixel> take_middles(const FineSampler& sampler,
                                       std::span<const glm::ivec2> pixels);
  /// Takes pattern samples of each pixel, with its mark, round by round, until it has enough.
  std::vector<DrawnPixel> take(const FineSampler& sampler, std::span<const glm::ivec2> pixels,
                               std::span<const std::uint16_t> marks);

 private:
  template <typename SampleOf, typename Keep>
  void trace(std::size_t count, const SampleOf& sample_of, const Keep& keep);
  void trace(int count, bool recorded);
  void add_surface(int index, PixelSurfaces& surfaces) const;
  template <typename SampleOf>
  void take(const std::vector<DrawnPixel*>& pixels, std::size_t each, const SampleOf& sample_of);
  void lens_pixels(std::vector<DrawnPixel>& pixels);
  void cell_pixels(std::vector<DrawnPixel>& pixels);
  void find_centers(std::vector<DrawnPixel>& pixels);

  const WaveScene& scene_;
  WavePool& pool_;
  const SurfaceWish& wish_;
  RayCounts& counts_;
  WavePointer memory_;
  WaveArray<CameraSample, wave_samples> samples_;
  WaveArray<WaveSight, wave_samples> sights_;
  std::vector<SurfaceSample> surfaces_;  // by sample, if requested
  std::vector<Color> light_colors_;      // by sample and separately recorded light
};

}  // namespace scenefile
