#include "scenefile/trace/explain.h"

#include "scenefile/trace/course_samples.h"
#include "scenefile/trace/edges.h"
#include "scenefile/trace/fine_samples.h"
#include "scenefile/trace/no_denormals.h"
#include "scenefile/trace/recorder.h"
#include "scenefile/trace/tiles.h"
#include "scenefile/trace/wave.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scenefile {

namespace {

// What the center samples of a pixel and its neighbors see. `middle`: the index of the pixel
// itself.
struct Neighborhood {
  std::vector<CameraSample> samples;
  std::vector<WaveSight> sights;
  std::size_t middle = 0;
};

Neighborhood neighborhood(const Tracer& tracer, const CameraRays& camera,
                          const FineSampler& sampler, int x, int y) {
  Neighborhood result;
  for (int y1 = std::max(0, y - 1); y1 <= std::min(tracer.options.height - 1, y + 1); ++y1) {
    for (int x1 = std::max(0, x - 1); x1 <= std::min(tracer.options.width - 1, x + 1); ++x1) {
      if (x1 == x && y1 == y) {
        result.middle = result.samples.size();
      }
      result.samples.push_back(sampler.middle(x1, y1));
    }
  }
  result.sights.resize(result.samples.size());
  const WaveScene scene(tracer, camera);
  RayCounts counts;
  trace_wave(scene, result.samples.data(), static_cast<int>(result.samples.size()), *make_wave(),
             result.sights.data(), counts);
  return result;
}

float largest_contrast(const Neighborhood& near) {
  const auto kept = [](const WaveSight& s) { return kept_signature(s.signature); };
  const WaveSight& middle = near.sights[near.middle];
  const glm::vec3 color(middle.color);
  float most = 0;
  for (const WaveSight& sight : near.sights) {
    const glm::vec3 beside(sight.color);
    most = std::max(most, contrast(&color.x, &beside.x, kept(sight) == kept(middle)));
  }
  return most;
}

// Takes the samples that render() takes in its passes.
Color fine_pixel(const Tracer& tracer, const CameraRays& camera, int x, int y, RayCounts& counts,
                 MoreSamples& more) {
  const FineSampler sampler(tracer, camera);
  std::uint8_t mark = 0;
  if (sampler.plan().two_passes()) {
    const Neighborhood near = neighborhood(tracer, camera, sampler, x, y);
    const float most = largest_contrast(near);
    mark = sampler.mark_of(most);
    more.neighbors = mark != 0;
  }
  if (sampler.plan().middles && mark == 0) {
    return trace_sample(tracer, camera, sampler.middle(x, y), counts);
  }
  PixelSamples samples;
  const std::uint32_t first = sampler.next_count(0);
  sampler.take(x, y, mark, samples, counts);
  more.noisy = samples.count > first;
  more.penumbra = more.noisy && samples.penumbra;
  return samples.mean();
}

// Links samples of the adaptive pattern to those that replace them.
void link_cell(std::vector<SampleRecord>& samples) {
  std::vector<glm::dvec2> points;
  for (const SampleRecord& sample : samples) {
    points.push_back(sample.point);
  }
  const std::vector<std::uint32_t> links = course::refined_samples(points);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].refines = links[i];
    if (links[i] != no_index) {
      samples[links[i]].refined = true;
    }
  }
}

std::uint32_t nearest_to_middle(const std::vector<SampleRecord>& samples, int x, int y) {
  std::uint32_t best = 0;
  double least = 2;
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    const double distance = glm::length(samples[i].point - glm::dvec2(x + 0.5, y + 0.5));
    if (!samples[i].refined && distance < least) {
      least = distance;
      best = i;
    }
  }
  return best;
}

}  // namespace

struct Explainer::Impl {
  Impl(const RenderScene& scene, const Assets& assets, const RenderOptions& options)
      : limit(options.threads),
        tracer(TraceScene(scene, assets, {.instance_names = true}), scene, options),
        camera(tracer.camera()) {}

  Color trace(int x, int y, PixelRecorder& recorder, MoreSamples& more) const {
    RayCounts counts;
    counts.recorder = &recorder;
    const Color color = tracer.course() ? course_pixel(tracer, camera, x, y, counts)
                                        : fine_pixel(tracer, camera, x, y, counts, more);
    if (tracer.course() && !camera.has_lens() && tracer.options.features.super_sample) {
      link_cell(recorder.samples);
    }
    return color;
  }

  ThreadLimit limit;
  Tracer tracer;
  CameraRays camera;
};

Explainer::Explainer(const RenderScene& scene, const Assets& assets, const RenderOptions& options)
    : impl_(std::make_unique<Impl>(scene, assets, options)) {}

Explainer::~Explainer() = default;

RenderStatus Explainer::status() const {
  return impl_->tracer.status();
}

PixelRecord Explainer::explain(int x, int y, std::optional<std::uint32_t> sample) const {
  const NoDenormals no_denormals;
  PixelRecord pixel;
  pixel.x = x;
  pixel.y = y;
  pixel.options = impl_->tracer.options;
  PixelRecorder recorder(impl_->tracer, sample);
  pixel.color = impl_->trace(x, y, recorder, pixel.more);
  pixel.shown = sample.value_or(0);
  if (recorder.rays.empty()) {
    pixel.shown = nearest_to_middle(recorder.samples, x, y);
    PixelRecorder again(impl_->tracer, pixel.shown);
    impl_->trace(x, y, again, pixel.more);
    recorder.rays = std::move(again.rays);
  }
  pixel.samples = std::move(recorder.samples);
  pixel.rays = std::move(recorder.rays);
  for (int c = 0; c < 3; ++c) {
    pixel.picture[c] = static_cast<float>(pixel.color[c]);
    pixel.value[c] = quantize(pixel.picture[c], rounding_of(pixel.options.profile));
  }
  return pixel;
}

}  // namespace scenefile
