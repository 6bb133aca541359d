#pragma once
// Samples pixels in wavefronts.

#include "scenefile/trace/adaptive_sampler.h"
#include "scenefile/trace/aov_sample.h"
#include "scenefile/trace/wavefront_memory.h"

#include <cstddef>
#include <mutex>
#include <span>
#include <vector>

namespace scenefile {

/// A pixel with its samples.
struct SampledPixel {
  glm::ivec2 at{0};
  Color color{0};                  ///< of the course profile
  PixelSamples samples;            ///< of the fine profile
  std::uint32_t surface_hash = 0;  ///< of the last sample; only set by wavefronts
  PixelAovs surfaces;              ///< if requested
};

/// Which surface data of camera rays to record.
struct AovRequest {
  bool wanted = false;
  std::vector<std::uint32_t> lights;  ///< lights to record separately, into RenderScene::lights
  bool centers = false;               ///< also the surface at the center of each pixel
};

inline std::vector<SampledPixel> pixels_at(std::span<const glm::ivec2> places) {
  std::vector<SampledPixel> pixels(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    pixels[i].at = places[i];
  }
  return pixels;
}

/// Wavefront memory that is not in use by any thread.
class WavefrontPool {
 public:
  WavefrontPointer take();
  /// A wavefront that take() returned. Destructors call it, so there is room for it.
  void give(WavefrontPointer wavefront) noexcept;

 private:
  std::mutex mutex_;
  std::size_t made_ = 0;  // all wavefronts, free or not
  std::vector<WavefrontPointer> free_;
};

/// Takes the samples of the pixels of a tile, in one thread.
class PixelSampler {
 public:
  PixelSampler(const WavefrontScene& scene, WavefrontPool& pool, const AovRequest& request,
               RayCounts& counts);
  ~PixelSampler();
  PixelSampler(const PixelSampler&) = delete;
  PixelSampler& operator=(const PixelSampler&) = delete;

  /// The centers of at most wavefront_samples pixels, in the order of `pixels`; valid until the
  /// next call. Not recorded.
  std::span<const SampleResult> center_samples(std::span<const glm::ivec2> pixels);
  /// The samples of the course profile: one at the center, the adaptive cell, or the lens samples.
  std::vector<SampledPixel> course(std::span<const glm::ivec2> pixels);
  /// AdaptiveSampler::center_sample() of at most wavefront_samples pixels, in the order of
  /// `pixels`; valid until the next call. Not recorded.
  std::span<const SampleResult> center_samples(const AdaptiveSampler& sampler,
                                               std::span<const glm::ivec2> pixels);
  /// One recorded center sample of each pixel.
  std::vector<SampledPixel> take_center_samples(const AdaptiveSampler& sampler,
                                                std::span<const glm::ivec2> pixels);
  /// Takes pattern samples of each pixel, round by round, until it has enough. `refinements`: of
  /// the pixels, from the refinement map.
  std::vector<SampledPixel> take(const AdaptiveSampler& sampler, std::span<const glm::ivec2> pixels,
                                 std::span<const std::uint16_t> refinements);

 private:
  template <typename SampleOf, typename Keep>
  void trace(std::size_t count, const SampleOf& sample_of, const Keep& keep);
  void trace(int count, bool recorded);
  void add_surface(int index, PixelAovs& surfaces) const;
  template <typename SampleOf>
  void take(const std::vector<SampledPixel*>& pixels, std::size_t each, const SampleOf& sample_of);
  void lens_pixels(std::vector<SampledPixel>& pixels);
  void cell_pixels(std::vector<SampledPixel>& pixels);
  void find_centers(std::vector<SampledPixel>& pixels);

  const WavefrontScene& scene_;
  WavefrontPool& pool_;
  const AovRequest& request_;
  RayCounts& counts_;
  WavefrontPointer memory_;
  UninitializedArray<CameraSample, wavefront_samples> samples_;
  UninitializedArray<SampleResult, wavefront_samples> results_;
  std::vector<AovSample> surfaces_;  // by sample, if requested
  std::vector<Color> light_colors_;  // by sample and separately recorded light
};

}  // namespace scenefile
