#include "trace/single_pixels.h"

namespace scenefile {

SingleSampler::SingleSampler(const Tracer& tracer, const CameraRays& camera,
                             const SurfaceWish& wish, ScalarCounts& counts)
    : tracer_(tracer), camera_(camera), wish_(wish), counts_(counts) {}

// Calls draw_pixel(pixel, counts) for each pixel.
template <typename Draw>
std::vector<DrawnPixel> SingleSampler::draw(std::span<const glm::ivec2> places,
                                            const Draw& draw_pixel) {
  std::vector<DrawnPixel> pixels = pixels_at(places);
  SurfaceRecorder recorder(tracer_.scene, wish_.lights);
  counts_.recorder = wish_.wanted ? &recorder : nullptr;
  for (DrawnPixel& pixel : pixels) {
    recorder.clear();
    draw_pixel(pixel, counts_);
    pixel.surfaces = recorder.surfaces();
  }
  counts_.recorder = nullptr;
  return pixels;
}

std::vector<DrawnPixel> SingleSampler::course(std::span<const glm::ivec2> places) {
  return draw(places, [&](DrawnPixel& pixel, ScalarCounts& counts) {
    pixel.color = course_pixel(tracer_, camera_, pixel.at.x, pixel.at.y, counts);
  });
}

std::vector<DrawnPixel> SingleSampler::take_middles(const FineSampler& sampler,
                                                    std::span<const glm::ivec2> places) {
  return draw(places, [&](DrawnPixel& pixel, ScalarCounts& counts) {
    const std::uint64_t penumbras = counts.penumbras;
    const Color color =
        trace_sample(tracer_, camera_, sampler.middle(pixel.at.x, pixel.at.y), counts);
    pixel.samples.add(color, counts.penumbras != penumbras);
  });
}

std::vector<DrawnPixel> SingleSampler::take(const FineSampler& sampler,
                                            std::span<const glm::ivec2> places,
                                            std::span<const std::uint16_t> marks) {
  std::size_t i = 0;
  return draw(places, [&](DrawnPixel& pixel, ScalarCounts& counts) {
    take_samples(tracer_, camera_, sampler, pixel.at.x, pixel.at.y, marks[i++], pixel.samples,
                 counts);
  });
}

}  // namespace scenefile
