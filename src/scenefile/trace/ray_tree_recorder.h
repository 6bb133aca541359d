#pragma once
// What wavefronts of one lane (one_lane_wavefront.cpp) keep of their rays, for explain.h. The
// wavefronts of pictures have no recorder, and are compiled without it.

#include "scenefile/trace/explain.h"
#include "scenefile/trace/wavefront_memory.h"

#include <cstdint>
#include <vector>

namespace scenefile {

struct RayTreeRecorder {
  RecordedPoints points;        ///< of the current points
  RecordedLight light;          ///< of the current sample of a light
  std::vector<RayRecord> rays;  ///< by node

  /// The record of ray r of the generation.
  RayRecord& of(const RayQueue& generation, std::uint32_t r) { return rays[generation.node[r]]; }
};

/// The object of primitive `source`, which a ray hit first.
ObjectRef object_at(const Tracer& tracer, const Ray& ray, double start, std::uint32_t source);

/// The objects between a point of the object `itself` and a light, each once, as they count for the
/// shadow; objects behind an opaque one do not count.
std::vector<Blocker> blockers_of(const Tracer& tracer, const Ray& to_light, double start,
                                 double end, const Hit& itself);

/// Traces one sample in one lane; returns all its rays, each before the rays that it causes, the
/// reflected one first.
std::vector<RayRecord> trace_recorded(const WavefrontScene& scene, const CameraSample& sample,
                                      WavefrontMemory& memory);

}  // namespace scenefile
