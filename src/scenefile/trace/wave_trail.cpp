#include "scenefile/trace/wave_trail.h"

#include <algorithm>
#include <limits>

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

}  // namespace scenefile
