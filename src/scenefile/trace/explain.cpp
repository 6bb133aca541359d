#include "scenefile/trace/explain.h"

#include "scenefile/trace/adaptive_sampler.h"
#include "scenefile/trace/course_samples.h"
#include "scenefile/trace/edges.h"
#include "scenefile/trace/no_denormals.h"
#include "scenefile/trace/pixel_sampler.h"
#include "scenefile/trace/ray_tree_recorder.h"
#include "scenefile/trace/tiles.h"

#include <algorithm>
#include <utility>

namespace scenefile {

namespace {

// A pixel and its neighbors.
std::vector<glm::ivec2> neighborhood(const RenderOptions& options, const glm::ivec2& at) {
  std::vector<glm::ivec2> pixels;
  for (int y = std::max(0, at.y - 1); y <= std::min(options.height - 1, at.y + 1); ++y) {
    for (int x = std::max(0, at.x - 1); x <= std::min(options.width - 1, at.x + 1); ++x) {
      pixels.emplace_back(x, y);
    }
  }
  return pixels;
}

// What the first pass of a picture stores of a pixel.
struct FirstLook {
  glm::vec3 color;
  std::uint16_t surface_hash;
  bool complete;  // it took all samples
};

Contrast largest_contrast(const std::vector<FirstLook>& looks, const FirstLook& center) {
  Contrast contrast;
  for (const FirstLook& look : looks) {
    raise(contrast, &center.color.x, &look.color.x, look.surface_hash == center.surface_hash);
  }
  return contrast;
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

std::uint32_t nearest_to_center(const std::vector<SampleRecord>& samples, int x, int y) {
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
        camera(tracer.camera()),
        wavefronts(tracer, camera),
        sampler(tracer, camera) {}

  std::vector<FirstLook> first_pass(PixelSampler& pixel_sampler,
                                    const std::vector<glm::ivec2>& pixels) {
    std::vector<FirstLook> looks;
    if (sampler.plan().centers_first) {
      for (const SampleResult& result : pixel_sampler.center_samples(sampler, pixels)) {
        looks.push_back({result.color, kept_hash(result.surface_hash), false});
      }
      return looks;
    }
    const std::vector<std::uint16_t> refinements(pixels.size());
    for (const SampledPixel& pixel : pixel_sampler.take(sampler, pixels, refinements)) {
      looks.push_back({pixel.samples.mean(), 0, pixel.samples.count == sampler.plan().most});
    }
    return looks;
  }

  // As render() draws it.
  SampledPixel draw(const glm::ivec2& at, MoreSamples& more) {
    const AovRequest request{true, {}, false};
    RayCounts counts;
    PixelSampler pixel_sampler(wavefronts, pool, request, counts);
    const std::span<const glm::ivec2> only(&at, 1);
    if (tracer.course()) {
      return std::move(pixel_sampler.course(only).front());
    }
    std::uint16_t refinement = 0;
    if (sampler.plan().two_passes) {
      const std::vector<glm::ivec2> pixels = neighborhood(tracer.options, at);
      const std::vector<FirstLook> looks = first_pass(pixel_sampler, pixels);
      const auto center = std::find(pixels.begin(), pixels.end(), at) - pixels.begin();
      const FirstLook& own = looks[static_cast<std::size_t>(center)];
      refinement = own.complete ? 0 : sampler.refinement_of(largest_contrast(looks, own));
      more.neighbors = refinement != 0;
    }
    if (sampler.plan().centers_first && refinement == 0) {
      return std::move(pixel_sampler.take_center_samples(sampler, only).front());
    }
    SampledPixel pixel = std::move(pixel_sampler.take(sampler, only, {&refinement, 1}).front());
    const bool by_itself = sampler.plan().centers_first || refinement == 0;
    more.noisy = by_itself && pixel.samples.count > sampler.next_count(0);
    more.penumbra = more.noisy && pixel.samples.penumbra;
    return pixel;
  }

  std::vector<SampleRecord> records_of(const std::vector<AovSample>& samples) const {
    std::vector<SampleRecord> records;
    for (const AovSample& sample : samples) {
      SampleRecord& record = records.emplace_back();
      record.point = sample.camera.point;
      record.lens = sample.camera.lens;
      record.color = sample.color;
      record.rays = sample.rays;
      if (sample.hit) {
        record.object = object_at(tracer, camera.ray(record.point, record.lens), 0, sample.source);
      }
    }
    if (tracer.course() && !camera.has_lens() && tracer.options.features.super_sample) {
      link_cell(records);
    }
    return records;
  }

  std::vector<RayRecord> rays_of(const CameraSample& sample) {
    WavefrontPointer memory = pool.take();
    std::vector<RayRecord> rays = trace_recorded(wavefronts, sample, *memory);
    pool.give(std::move(memory));
    return rays;
  }

  ThreadLimit limit;
  Tracer tracer;
  CameraRays camera;
  WavefrontScene wavefronts;
  AdaptiveSampler sampler;
  WavefrontPool pool;
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
  const SampledPixel drawn = impl_->draw({x, y}, pixel.more);
  pixel.color = impl_->tracer.course() ? drawn.color : drawn.samples.mean();
  const std::vector<AovSample>& taken = drawn.surfaces.samples;
  pixel.samples = impl_->records_of(taken);
  pixel.shown =
      sample.value_or(no_index) < taken.size() ? *sample : nearest_to_center(pixel.samples, x, y);
  pixel.rays = impl_->rays_of(taken[pixel.shown].camera);
  for (int c = 0; c < 3; ++c) {
    pixel.picture[c] = static_cast<float>(pixel.color[c]);
    pixel.value[c] = quantize(pixel.picture[c], rounding_of(pixel.options.profile));
  }
  return pixel;
}

}  // namespace scenefile
