#pragma once
// What the assignment Realtime draws of a scene.

#include "scenefile/base/realtime.h"
#include "scenefile/verbs/load_scene.h"

#include <cstddef>
#include <vector>

namespace scenefile {

/// A light that the milestone does not support.
struct SkippedLight {
  LightType type = LightType::point;
  Location location;
};

/// The parts of a scene that the assignment draws.
struct RealtimeReport {
  RealtimeOptions options;
  std::size_t lights = 0;  ///< number of lights that are used
  std::vector<SkippedLight> skipped_lights;
  double triangles = 0;  ///< of all shapes after instancing, without meshes
};

RealtimeReport realtime_report(const RealtimeOptions& options, const LoadedScene& scene);

/// Adds findings about what the assignment does not draw.
void check_realtime(const RealtimeOptions& options, LoadedScene& scene);

}  // namespace scenefile
