#include "trace/single_pixels.h"

namespace scenefile {

SingleSampler::SingleSampler(const Tracer& tracer, const CameraRays& camera,
                             const AovRequest& request, ScalarCounts& counts)
    : tracer_(tracer), camera_(camera), request_(request), counts_(counts) {}

// Calls draw_pixel(pixel, counts) for each pixel.
template <typename Draw>
std::vector<SampledPixel> SingleSampler::draw(std::span<const glm::ivec2> places,
                                              const Draw& draw_pixel) {
  std::vector<SampledPixel> pixels = pixels_at(places);
  SurfaceRecorder recorder(tracer_.scene, request_.lights);
  counts_.recorder = request_.wanted ? &recorder : nullptr;
  for (SampledPixel& pixel : pixels) {
    recorder.clear();
    draw_pixel(pixel, counts_);
    pixel.surfaces = recorder.surfaces();
  }
  counts_.recorder = nullptr;
  return pixels;
}

std::vector<SampledPixel> SingleSampler::course(std::span<const glm::ivec2> places) {
  return draw(places, [&](SampledPixel& pixel, ScalarCounts& counts) {
    pixel.color = course_pixel(tracer_, camera_, pixel.at.x, pixel.at.y, counts);
  });
}

std::vector<SampledPixel> SingleSampler::take_center_samples(const AdaptiveSampler& sampler,
                                                             std::span<const glm::ivec2> places) {
  return draw(places, [&](SampledPixel& pixel, ScalarCounts& counts) {
    const std::uint64_t penumbras = counts.penumbras;
    const Color color =
        trace_sample(tracer_, camera_, sampler.center_sample(pixel.at.x, pixel.at.y), counts);
    pixel.samples.add(color, counts.penumbras != penumbras);
  });
}

std::vector<SampledPixel> SingleSampler::take(const AdaptiveSampler& sampler,
                                              std::span<const glm::ivec2> places,
                                              std::span<const std::uint16_t> refinements) {
  std::size_t i = 0;
  return draw(places, [&](SampledPixel& pixel, ScalarCounts& counts) {
    take_samples(tracer_, camera_, sampler, pixel.at.x, pixel.at.y, refinements[i++], pixel.samples,
                 counts);
  });
}

}  // namespace scenefile
