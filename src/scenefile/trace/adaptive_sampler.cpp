#include "scenefile/trace/adaptive_sampler.h"

#include "scenefile/base/components.h"
#include "scenefile/base/shape_traits.h"
#include "scenefile/trace/sequence.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

constexpr std::uint32_t first_round = 4;

// Samples per area light at hits of camera rays; secondary rays use one.
constexpr std::uint32_t light_samples = 4;

// The minimum variance assumed for a pixel that sees an area light partially, relative to its
// squared color: points on a light are spread so evenly that a few samples may agree and be wrong.
constexpr double variance_of_penumbra = 1.0 / 16;

// A pixel with this variance justifies the maximum number of samples, but at least usual_samples:
// with a smaller maximum, pixels take fewer samples, but the same pixels are refined.
constexpr double worst_variance = 1.0 / 45;
constexpr std::uint32_t usual_samples = 16;

// The variance within a pixel relative to the contrast with its neighbors: 1/12 for a linear
// gradient.
constexpr double variance_of_contrast = 1.0 / 12;

// The variance estimated from the contrast counts as much as this many samples: many, because a
// pixel whose own samples decide when to stop is biased. In a mostly dark pixel, for example, the
// first samples may all miss a small bright area, agree, and end the sampling.
constexpr double weight_of_contrast = 150;

// A pixel is refined even if its first round gains only this share of what samples must gain later:
// near fine geometry, center samples that miss it agree with their neighbors, and keeping too many
// of them would darken the picture.
constexpr double share_for_first_round = 0.25;

// The refinement map has square roots of contrasts, in these units.
constexpr double refinement_unit = 1.0 / 65535;

// If at least this many samples are allowed, every pixel gets at least 1 / share_for_exactness of
// them.
constexpr std::uint32_t samples_for_exactness = 256;
constexpr std::uint32_t share_for_exactness = 32;

// The first round, for pictures in which every pixel starts with pattern samples.
constexpr std::uint32_t first_samples = 4;

// If a lens blurs the background by a radius of more pixels than this, agreement of four samples
// says too little.
constexpr double strong_blur = 8;

// Behind a lens, a pixel has enough samples if the standard error of its mean is below this, and no
// neighbor differs by more than `settled_contrast`. If its own samples alone decided, those that
// miss something small and bright would end the sampling, and the picture would be too dark.
constexpr double settled_error = 1.0 / 128;
constexpr double settled_contrast = 1.0 / 20;

// The squared error of the mean of `count` samples, for a variance of 1.
double error_of(std::uint32_t count) {
  return 1 / (count * std::sqrt(double(count)));
}

double gain(std::uint32_t count, std::uint32_t more) {
  return (error_of(count) - error_of(more)) / (more - count);
}

// The gain per sample from count / 2 to `count` samples.
double gain_of_last(std::uint32_t count) {
  return gain(count / 2, count);
}

double expected_variance(std::uint16_t refinement) {
  const double difference = refinement * refinement_unit;
  return variance_of_contrast * difference * difference;
}

}  // namespace

void PixelSamples::add(const Color& color, bool partly_lit) {
  const Color clamped = glm::clamp(color, Color(0), Color(1));
  sum += color;
  clamped_sum += clamped;
  sum_of_squares += clamped * clamped;
  penumbra = penumbra || partly_lit;
  ++count;
}

double PixelSamples::variance() const {
  if (count < 2) {
    return 0;
  }
  const Color mean_clamped = clamped_sum / double(count);
  const Color of_channels =
      (sum_of_squares - double(count) * mean_clamped * mean_clamped) / (count - 1.0);
  return std::max(0.0, (of_channels.x + of_channels.y + of_channels.z) / 3);
}

NoiseSource noise_source(const RenderScene& scene, const RenderOptions& options) {
  const CameraRays camera(scene.camera, options.width, options.height);
  if (options.features.depthoffield && camera.has_lens()) {
    const double strong = strong_blur * camera.pixel_spread() * scene.camera.focal_length;
    return scene.camera.aperture > strong ? NoiseSource::strong_lens : NoiseSource::lens;
  }
  const auto is_area = [](const RenderLight& light) { return has_rectangle(light.type); };
  return std::any_of(scene.lights.begin(), scene.lights.end(), is_area) ? NoiseSource::area_lights
                                                                        : NoiseSource::none;
}

SamplePlan sample_plan(const RenderOptions& options, NoiseSource noise_source) {
  SamplePlan plan;
  plan.most = static_cast<std::uint32_t>(std::max(1, options.samples));
  plan.first = static_cast<std::uint32_t>(std::max(1, options.min_samples));
  if (plan.most >= samples_for_exactness) {
    plan.first = std::max(plan.first, plan.most / share_for_exactness);
  }
  if (noise_source == NoiseSource::strong_lens) {
    plan.first = plan.most;
  } else if (noise_source == NoiseSource::lens) {
    plan.first = std::max(plan.first, std::clamp(plan.most / 4, 2u, first_samples));
  } else if (noise_source == NoiseSource::area_lights) {
    plan.first = std::max(plan.first, first_samples);
  }
  plan.first = std::min(plan.first, plan.most);
  plan.centers_first = plan.first == 1 && noise_source == NoiseSource::none;
  plan.two_passes =
      plan.first < plan.most && (plan.centers_first || noise_source == NoiseSource::lens);
  return plan;
}

AdaptiveSampler::AdaptiveSampler(const Tracer& tracer, const CameraRays& camera)
    : camera_(camera),
      seed_(mixed_bits(static_cast<std::uint32_t>(tracer.options.seed),
                       static_cast<std::uint32_t>(tracer.options.seed >> 32))),
      plan_(sample_plan(tracer.options, noise_source(tracer.scene, tracer.options))),
      min_gain_(worst_variance * gain_of_last(std::max(plan_.most, usual_samples))) {}

// A sample that covers a quarter of the pixel, as in the first round of four.
CameraSample AdaptiveSampler::sample_at(int x, int y, std::uint32_t index,
                                        const glm::dvec2& in_pixel) const {
  const std::uint32_t pixel =
      mixed_bits(mixed_bits(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)), seed_);
  const glm::dvec2 on_lens = camera_.has_lens()
                                 ? disk_of_square(stratified_2d(index, mixed_bits(pixel, 2)))
                                 : glm::dvec2(0);
  return {glm::dvec2(x, y) + in_pixel, on_lens, 0.5, {index, mixed_bits(pixel, 3), light_samples}};
}

CameraSample AdaptiveSampler::center_sample(int x, int y) const {
  CameraSample sample = sample_at(x, y, 0, glm::dvec2(0.5));
  sample.width = 1;
  sample.key.texture_grid = 2;
  return sample;
}

CameraSample AdaptiveSampler::sample(int x, int y, std::uint32_t index) const {
  const std::uint32_t pixel =
      mixed_bits(mixed_bits(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)), seed_);
  const glm::dvec2 in_pixel =
      plan_.most == 1 ? glm::dvec2(0.5) : stratified_2d(index, mixed_bits(pixel, 1));
  return sample_at(x, y, index, in_pixel);
}

std::uint32_t AdaptiveSampler::next_count(std::uint32_t count) const {
  // A few samples of a strong blur often agree by chance, usually on the background; stopping then
  // would darken small bright objects.
  if (camera_.has_lens() && count != 0) {
    return plan_.most;
  }
  const std::uint32_t first = plan_.centers_first ? first_round : plan_.first;
  return std::min(count == 0 ? first : 2 * count, plan_.most);
}

bool AdaptiveSampler::worth(double variance, std::uint32_t count, std::uint32_t more) const {
  return variance * gain(count, more) > min_gain_;
}

bool AdaptiveSampler::enough(const PixelSamples& samples, std::uint16_t refinement) const {
  if (samples.count >= plan_.most) {
    return true;
  }
  if (camera_.has_lens()) {
    return refinement == 0 && !samples.penumbra &&
           samples.variance() <= settled_error * settled_error * samples.count;
  }
  const double degrees = samples.count - 1.0;
  const double weight = refinement == 0 ? 0 : weight_of_contrast;
  double variance = (weight * expected_variance(refinement) + degrees * samples.variance()) /
                    std::max(1.0, weight + degrees);
  if (samples.penumbra) {
    const Color mean = samples.clamped_sum / double(samples.count);
    variance = std::max(variance, variance_of_penumbra * glm::dot(mean, mean) / 3);
  }
  return !worth(variance, samples.count, next_count(samples.count));
}

std::uint16_t AdaptiveSampler::refinement_of(const Contrast& contrast) const {
  if (camera_.has_lens()) {
    return contrast.most > settled_contrast * settled_contrast ? 1 : 0;
  }
  // The center sample is discarded, so the first round must gain what is left to gain.
  const std::uint32_t first = next_count(0);
  const double all = variance_of_contrast * contrast.edges * (1 - error_of(first)) / first;
  if (all <= share_for_first_round * min_gain_) {
    return 0;
  }
  const double rounded = std::ceil(std::sqrt(double(contrast.most)) / refinement_unit);
  return static_cast<std::uint16_t>(std::clamp(rounded, 1.0, 1 / refinement_unit));
}

}  // namespace scenefile
