#pragma once
// A ray on its path through reflections and refractions.

#include "scenefile/base/components.h"
#include "scenefile/trace/accelerator.h"
#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/explain.h"
#include "scenefile/trace/ray_differential.h"
#include "scenefile/trace/sequence.h"

namespace scenefile {

/// The maximum number of rays caused by one sample. Physical materials stay far below it; it bounds
/// scenes whose mirrors and glass return more light than they receive.
inline constexpr std::uint32_t rays_of_a_sample = 4096;

/// The transparent object that a ray is inside of, and those around it.
struct Inside {
  const Hit* hit = nullptr;
  const Inside* around = nullptr;
};

/// Fine profile: rays that can change the picture by less than this are not followed.
inline constexpr double min_weight = 1.0 / 1024;

struct Path {
  Ray ray;
  RayDifferential differential;
  SampleKey key;
  double start = 0;  ///< smallest t of hits
  RayKind kind = RayKind::camera;
  int depth = 0;                            ///< reflections and refractions so far
  double weight = 1;                        ///< fraction of the pixel that the ray can still change
  std::uint32_t budget = rays_of_a_sample;  ///< rays that it may still cause, with itself
  const Inside* inside = nullptr;
};

/// A reflected or refracted path without its direction; `factor` multiplies its light.
inline Path child_of(const Path& path, const Color& factor, std::uint32_t budget, RayKind kind) {
  Path child = path;
  child.kind = kind;
  child.depth = path.depth + 1;
  child.weight = path.weight * largest(factor);
  child.budget = budget;
  child.key.light_samples = 1;
  child.key.pattern = mixed_bits(path.key.pattern, static_cast<std::uint32_t>(kind));
  return child;
}

}  // namespace scenefile
