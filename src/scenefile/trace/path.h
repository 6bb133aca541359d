#pragma once
// A ray on its way through mirrors and glass.

#include "scenefile/trace/explain.h"
#include "scenefile/trace/shade.h"

namespace scenefile {

/// A ray and all that come of it are at most so many. Physical materials stay far below; the bound
/// is for scenes whose mirrors and glass give back more than they get.
inline constexpr std::uint32_t rays_of_a_sample = 4096;

/// The transparent object that a ray is in, and those around it.
struct Inside {
  const Hit* object = nullptr;
  const Inside* around = nullptr;
};

struct Path {
  Ray ray;
  RayCone cone;
  SampleKey key;
  double start = 0;  ///< smallest t of a hit
  RayKind kind = RayKind::camera;
  int depth = 0;                            ///< reflections and refractions so far
  double weight = 1;                        ///< share of the pixel that the ray can still change
  std::uint32_t budget = rays_of_a_sample;  ///< rays that it may still become, itself included
  const Inside* inside = nullptr;
};

}  // namespace scenefile
