#pragma once
// Samples pixels ray by ray.

#include "scenefile/trace/pixel_sampler.h"
#include "trace/scalar_tracer.h"
#include "trace/surface_recorder.h"

namespace scenefile {

/// Same interface as PixelSampler.
class SingleSampler {
 public:
  SingleSampler(const Tracer& tracer, const CameraRays& camera, const AovRequest& request,
                ScalarCounts& counts);

  std::vector<SampledPixel> course(std::span<const glm::ivec2> pixels);
  std::vector<SampledPixel> take_center_samples(const AdaptiveSampler& sampler,
                                                std::span<const glm::ivec2> pixels);
  std::vector<SampledPixel> take(const AdaptiveSampler& sampler, std::span<const glm::ivec2> pixels,
                                 std::span<const std::uint16_t> refinements);

 private:
  template <typename Draw>
  std::vector<SampledPixel> draw(std::span<const glm::ivec2> places, const Draw& draw_pixel);

  const Tracer& tracer_;
  const CameraRays& camera_;
  const AovRequest& request_;
  ScalarCounts& counts_;
};

}  // namespace scenefile
