// Waves of one lane, which keep what they compute: what explain.h shows is what the kernel of the
// pictures did.

#include "scenefile/base/components.h"
#include "scenefile/base/one_lane.h"
#include "scenefile/trace/next_up.h"
#include "scenefile/trace/optics.h"
#include "scenefile/trace/sequence.h"
#include "scenefile/trace/wave_memory.h"

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
#include "scenefile/trace/wave_kernel-inl.h"

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
    const glm::i64vec3& density = tracer.transmission.density(hit.material);
    found.push_back({object_at(tracer, to_light, from, hit.source), hit.t,
                     Transmission::factor(density), same(itself)});
    if (Transmission::blocks(density)) {
      break;
    }
  }
  return found;
}

namespace {

bool trace_with_trail(const WaveScene& scene, const CameraSample* samples, int count,
                      WaveMemory& memory, WaveSight* sights, RayCounts& counts,
                      const WaveRecord* record, WaveTrail& trail) {
  memory.trail = &trail;
  memory.points.notes = memory.walls.notes = &trail.points;
  memory.light.notes = &trail.light;
  return one::trace(scene, samples, count, memory, sights, counts, record);
}

// Large arrays, of which little is used: not initialized.
std::unique_ptr<WaveTrail> make_trail() {
  return std::unique_ptr<WaveTrail>(new WaveTrail);
}

// Copies the record of node `index` and those of the rays that it causes.
void append_in_order(std::vector<RayRecord>& by_node, std::uint32_t index, std::uint32_t parent,
                     std::vector<RayRecord>& rays) {
  const auto place = static_cast<std::uint32_t>(rays.size());
  rays.push_back(std::move(by_node[index]));
  rays[place].parent = parent;
  for (BranchRecord RayRecord::*branch : {&RayRecord::mirror, &RayRecord::glass}) {
    if ((rays[place].*branch).fate == Fate::followed) {
      const std::uint32_t child =
          std::exchange((rays[place].*branch).ray, static_cast<std::uint32_t>(rays.size()));
      append_in_order(by_node, child, place, rays);  // the depth is at most max_depth
    }
  }
}

}  // namespace

const WaveKernel& one_lane_kernel() {
  static constexpr WaveKernel kernel{
      "one lane", [] { return true; },
      [](const WaveScene& scene, const CameraSample* samples, int count, WaveMemory& memory,
         WaveSight* sights, RayCounts& counts, const WaveRecord* record) {
        return trace_with_trail(scene, samples, count, memory, sights, counts, record,
                                *make_trail());
      }};
  return kernel;
}

std::vector<RayRecord> trace_recorded(const WaveScene& scene, const CameraSample& sample,
                                      WaveMemory& memory) {
  const std::unique_ptr<WaveTrail> trail = make_trail();
  RayCounts counts;
  WaveSight sight;
  trace_with_trail(scene, &sample, 1, memory, &sight, counts, nullptr, *trail);
  std::vector<RayRecord> rays;
  rays.reserve(trail->rays.size());
  append_in_order(trail->rays, 0, no_index, rays);
  return rays;
}

}  // namespace scenefile
