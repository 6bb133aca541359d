#pragma once
// Samples pixels ray by ray.

#include "scenefile/trace/wave_pixels.h"
#include "trace/scalar_tracer.h"
#include "trace/surface_recorder.h"

namespace scenefile {

/// Same interface as WaveSampler.
class SingleSampler {
 public:
  SingleSampler(const Tracer& tracer, const CameraRays& camera, const SurfaceWish& wish,
                ScalarCounts& counts);

  std::vector<DrawnPixel> course(std::span<const glm::ivec2> pixels);
  std::vector<DrawnPixel> take_middles(const FineSampler& sampler,
                                       std::span<const glm::ivec2> pixels);
  std::vector<DrawnPixel> take(const FineSampler& sampler, std::span<const glm::ivec2> pixels,
                               std::span<const std::uint16_t> marks);

 private:
  template <typename Draw>
  std::vector<DrawnPixel> draw(std::span<const glm::ivec2> places, const Draw& draw_pixel);

  const Tracer& tracer_;
  const CameraRays& camera_;
  const SurfaceWish& wish_;
  ScalarCounts& counts_;
};

}  // namespace scenefile
