#pragma once
// A ray on its way through mirrors and glass.

#include "scenefile/base/components.h"
#include "scenefile/trace/explain.h"
#include "scenefile/trace/sequence.h"
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

/// Fine profile: light that can change the picture by less is not followed.
inline constexpr double min_weight = 1.0 / 1024;

/// A place of the picture that is looked at, in the units of CameraRays::ray().
struct CameraSample {
  glm::dvec2 point{0};
  glm::dvec2 lens{0};
  double width = 0;  ///< what the sample stands for, in pixels: textures are filtered over it
  SampleKey key;
};

struct Path {
  Ray ray;
  RayDifferential differential;
  SampleKey key;
  double start = 0;  ///< smallest t of a hit
  RayKind kind = RayKind::camera;
  int depth = 0;                            ///< reflections and refractions so far
  double weight = 1;                        ///< share of the pixel that the ray can still change
  std::uint32_t budget = rays_of_a_sample;  ///< rays that it may still become, itself included
  const Inside* inside = nullptr;
};

/// A mirrored or refracted path, but for where it goes; `factor`: what its light is multiplied by.
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
