// Wavefronts of one lane, which keep what they compute: what explain.h shows is what the kernel of
// the pictures did.

#include "scenefile/base/components.h"
#include "scenefile/base/one_lane.h"
#include "scenefile/trace/next_up.h"
#include "scenefile/trace/optics.h"
#include "scenefile/trace/sequence.h"
#include "scenefile/trace/wavefront_memory.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace scenefile::one {
inline constexpr bool recording = true;
}
#include "scenefile/trace/wavefront_kernel-inl.h"

namespace scenefile {

ObjectRef object_at(const Tracer& tracer, const Ray& ray, double start, std::uint32_t source) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {source, tracer.accelerator.instances_of_closest(ray, start, infinity)};
}

std::vector<Blocker> blockers_of(const Tracer& tracer, const Ray& to_light, double start,
                                 double end, const Hit& itself) {
  std::vector<Blocker> found;
  std::vector<Hit> hits;
  Hit hit;
  for (double from = start; found.size() < max_blockers; from = hit.t) {
    if (!tracer.accelerator.closest(to_light, from, end, hit)) {
      break;
    }
    const auto same = [&](const Hit& other) { return same_object(hit, other); };
    if (std::any_of(hits.begin(), hits.end(), same)) {
      continue;
    }
    hits.push_back(hit);
    const glm::i64vec3 density = tracer.transmission.density(hit.material);
    found.push_back({object_at(tracer, to_light, from, hit.source), hit.t,
                     Transmission::factor(density), same(itself)});
    if (Transmission::blocks(density)) {
      break;
    }
  }
  return found;
}

namespace {

bool trace_with_recorder(const WavefrontScene& scene, const CameraSample* samples, int count,
                         WavefrontMemory& memory, SampleResult* results, RayCounts& counts,
                         const AovOutput* aovs, RayTreeRecorder& recorder) {
  memory.recorder = &recorder;
  memory.points.recorded = memory.walls.recorded = &recorder.points;
  memory.light.recorded = &recorder.light;
  return one::trace(scene, samples, count, memory, results, counts, aovs);
}

// Large arrays, of which little is used: not initialized.
std::unique_ptr<RayTreeRecorder> make_recorder() {
  return std::unique_ptr<RayTreeRecorder>(new RayTreeRecorder);
}

// Copies the record of node `index` and those of the rays that it causes.
void append_in_order(std::vector<RayRecord>& by_node, std::uint32_t index, std::uint32_t parent,
                     std::vector<RayRecord>& rays) {
  const auto place = static_cast<std::uint32_t>(rays.size());
  rays.push_back(std::move(by_node[index]));
  rays[place].parent = parent;
  for (BranchRecord RayRecord::*branch : {&RayRecord::mirror, &RayRecord::glass}) {
    if ((rays[place].*branch).outcome == BranchOutcome::followed) {
      const std::uint32_t child =
          std::exchange((rays[place].*branch).ray, static_cast<std::uint32_t>(rays.size()));
      append_in_order(by_node, child, place, rays);  // the depth is at most max_depth
    }
  }
}

}  // namespace

const WavefrontKernel& one_lane_kernel() {
  static constexpr WavefrontKernel kernel{
      "one lane", [] { return true; },
      [](const WavefrontScene& scene, const CameraSample* samples, int count,
         WavefrontMemory& memory, SampleResult* results, RayCounts& counts, const AovOutput* aovs) {
        return trace_with_recorder(scene, samples, count, memory, results, counts, aovs,
                                   *make_recorder());
      }};
  return kernel;
}

std::vector<RayRecord> trace_recorded(const WavefrontScene& scene, const CameraSample& sample,
                                      WavefrontMemory& memory) {
  const std::unique_ptr<RayTreeRecorder> recorder = make_recorder();
  RayCounts counts;
  SampleResult result;
  trace_with_recorder(scene, &sample, 1, memory, &result, counts, nullptr, *recorder);
  std::vector<RayRecord> rays;
  rays.reserve(recorder->rays.size());
  append_in_order(recorder->rays, 0, no_index, rays);
  return rays;
}

}  // namespace scenefile
