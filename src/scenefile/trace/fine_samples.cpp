#include "scenefile/trace/fine_samples.h"

#include "scenefile/base/components.h"
#include "scenefile/trace/sequence.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

constexpr std::uint32_t first_round = 4;

// Points on each area light seen from what a camera ray hits; bounced rays look at one.
constexpr std::uint32_t light_samples = 4;

// A pixel is settled when its mean is uncertain by less than this.
constexpr double settled_error = 1.0 / 256;

constexpr double visible_difference = 1.0 / 16;

}  // namespace

void PixelSamples::add(const Color& color, bool partly_lit) {
  const Color clamped = glm::clamp(color, Color(0), Color(1));
  sum += color;
  clamped_sum += clamped;
  sum_of_squares += clamped * clamped;
  penumbra = penumbra || partly_lit;
  ++count;
}

double PixelSamples::error() const {
  if (count < 2) {
    return 0;
  }
  const Color mean_clamped = clamped_sum / double(count);
  const Color variance = (sum_of_squares - double(count) * mean_clamped * mean_clamped) /
                         (double(count) * (count - 1.0));
  return std::sqrt(std::max(0.0, largest(variance)));
}

FineSampler::FineSampler(const Tracer& tracer, const CameraRays& camera)
    : tracer_(tracer),
      camera_(camera),
      seed_(mixed_bits(static_cast<std::uint32_t>(tracer.options.seed),
                       static_cast<std::uint32_t>(tracer.options.seed >> 32))) {}

std::uint32_t FineSampler::first_samples(const RenderOptions& options) {
  const auto most = static_cast<std::uint32_t>(std::max(1, options.samples));
  return std::min(most, std::max(first_round, static_cast<std::uint32_t>(options.min_samples)));
}

CameraSample FineSampler::sample(int x, int y, std::uint32_t index) const {
  const std::uint32_t pixel =
      mixed_bits(mixed_bits(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)), seed_);
  const bool alone = tracer_.options.samples <= 1;
  const glm::dvec2 in_pixel = alone ? glm::dvec2(0.5) : stratified_2d(index, mixed_bits(pixel, 1));
  const glm::dvec2 on_lens = camera_.has_lens()
                                 ? disk_of_square(stratified_2d(index, mixed_bits(pixel, 2)))
                                 : glm::dvec2(0);
  // The first samples share the pixel between them, so each filters textures over its share.
  const RayCone cone{0, camera_.pixel_spread() / std::sqrt(double(first_samples()))};
  const SampleKey key{index, mixed_bits(pixel, 3), light_samples};
  return {glm::dvec2(x, y) + in_pixel, on_lens, cone, key};
}

void FineSampler::take(int x, int y, std::uint32_t count, PixelSamples& samples,
                       RayCounts& counts) const {
  while (samples.count < count) {
    const std::uint64_t penumbras = counts.penumbras;
    const Color color = trace_sample(tracer_, camera_, sample(x, y, samples.count), counts);
    samples.add(color, counts.penumbras != penumbras);
  }
}

std::uint32_t FineSampler::next_count(std::uint32_t count) const {
  const auto most = static_cast<std::uint32_t>(tracer_.options.samples);
  // Few samples of a wide blur agree by chance, mostly on what is behind it: to end then would
  // darken small bright things.
  return camera_.has_lens() || count > most / 2 ? most : count * 2;
}

void FineSampler::refine(int x, int y, PixelSamples& samples, RayCounts& counts) const {
  do {
    take(x, y, next_count(samples.count), samples, counts);
  } while (!enough(samples));
}

bool FineSampler::enough(const PixelSamples& samples) const {
  return samples.count >= static_cast<std::uint32_t>(tracer_.options.samples) || settled(samples);
}

bool settled(const PixelSamples& samples) {
  return !samples.penumbra && samples.error() <= settled_error;
}

bool differ(const Color& a, const Color& b) {
  const Color d = glm::abs(glm::clamp(a, Color(0), Color(1)) - glm::clamp(b, Color(0), Color(1)));
  return largest(d) > visible_difference;
}

}  // namespace scenefile
