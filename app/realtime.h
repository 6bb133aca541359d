#pragma once
// --profile realtime: its options, and its effect on a scene.

#include "app/load.h"
#include "app/options.h"
#include "scenefile/base/realtime.h"
#include "scenefile/grade/realtime_causes.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scenefile::app {

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

/// The assignment's settings from the options; nullopt for other profiles.
std::optional<RealtimeOptions> realtime_options(const Options& options);

/// Which settings are not given, so that diff and grade must find them in the reference.
RealtimeUnknowns realtime_unknowns(const Options& options);

RealtimeReport realtime_report(const RealtimeOptions& options, const LoadedScene& scene);

/// Adds findings about what the assignment does not draw.
void check_realtime(const RealtimeOptions& options, LoadedScene& scene);

/// Checks combinations of options. Returns an error message, as a phrase that follows "scenefile:
/// "; empty on success.
std::string check_realtime_options(const Options& options);

}  // namespace scenefile::app
