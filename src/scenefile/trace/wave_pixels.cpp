#include "scenefile/trace/wave_pixels.h"

#include <utility>

namespace scenefile {

namespace {

std::vector<WavePixel> without_samples(std::span<const glm::ivec2> pixels) {
  std::vector<WavePixel> result;
  result.reserve(pixels.size());
  for (const glm::ivec2& at : pixels) {
    result.push_back({at, {}});
  }
  return result;
}

std::vector<WavePixel*> pointers_to(std::vector<WavePixel>& pixels) {
  std::vector<WavePixel*> pointers;
  pointers.reserve(pixels.size());
  for (WavePixel& pixel : pixels) {
    pointers.push_back(&pixel);
  }
  return pointers;
}

}  // namespace

WavePointer WavePool::take() {
  const std::lock_guard lock(mutex_);
  if (free_.empty()) {
    return make_wave();
  }
  WavePointer wave = std::move(free_.back());
  free_.pop_back();
  return wave;
}

void WavePool::give(WavePointer wave) {
  const std::lock_guard lock(mutex_);
  free_.push_back(std::move(wave));
}

WaveSampler::WaveSampler(const WaveScene& scene, WavePool& pool, RayCounts& counts)
    : scene_(scene), pool_(pool), counts_(counts), memory_(pool.take()) {
  samples_.reserve(wave_samples);
}

WaveSampler::~WaveSampler() {
  pool_.give(std::move(memory_));
}

std::span<const WaveSight> WaveSampler::trace() {
  const std::size_t count = samples_.size();
  trace_wave(scene_, samples_.data(), static_cast<int>(count), *memory_, sights_.data(), counts_);
  samples_.clear();
  return {sights_.data(), count};
}

std::span<const WaveSight> WaveSampler::middles(std::span<const glm::ivec2> pixels) {
  for (const glm::ivec2& pixel : pixels) {
    samples_.push_back({glm::dvec2(pixel) + 0.5, {}, {}, {}});
  }
  return trace();
}

void WaveSampler::finish() {
  const std::span<const WaveSight> sights = trace();
  for (std::size_t i = 0; i < sights.size(); ++i) {
    owners_[i]->samples.add(sights[i].color, sights[i].penumbra);
  }
  owners_.clear();
}

void WaveSampler::add(WavePixel& pixel, const CameraSample& sample) {
  samples_.push_back(sample);
  owners_.push_back(&pixel);
  if (samples_.size() == wave_samples) {
    finish();
  }
}

void WaveSampler::take(const FineSampler& sampler, const std::vector<WavePixel*>& pixels,
                       std::uint32_t count) {
  for (WavePixel* const pixel : pixels) {
    for (std::uint32_t i = pixel->samples.count; i < count; ++i) {
      add(*pixel, sampler.sample(pixel->at.x, pixel->at.y, i));
    }
  }
  finish();
}

std::vector<WavePixel> WaveSampler::take(const FineSampler& sampler,
                                         std::span<const glm::ivec2> pixels) {
  std::vector<WavePixel> result = without_samples(pixels);
  take(sampler, pointers_to(result), sampler.first_samples());
  return result;
}

std::vector<WavePixel> WaveSampler::refine(const FineSampler& sampler,
                                           std::span<const glm::ivec2> pixels) {
  std::vector<WavePixel> result = take(sampler, pixels);
  std::vector<WavePixel*> left = pointers_to(result);
  std::uint32_t count = sampler.first_samples();
  while (!left.empty()) {
    count = sampler.next_count(count);
    take(sampler, left, count);
    std::erase_if(left, [&](const WavePixel* pixel) { return sampler.enough(pixel->samples); });
  }
  return result;
}

}  // namespace scenefile
