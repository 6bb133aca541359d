#pragma once
// What --profile realtime asks for, and what it makes of a scene.

#include "app/load.h"
#include "app/options.h"
#include "scenefile/view/realtime.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scenefile::app {

/// A light that the milestone does not know.
struct SkippedLight {
  LightType type = LightType::point;
  Location location;
};

/// What the assignment draws of a scene.
struct RealtimeReport {
  RealtimeOptions options;
  std::size_t lights = 0;  ///< that shine
  std::vector<SkippedLight> skipped_lights;
  double triangles = 0;  ///< of all shapes after instancing, without meshes
};

/// The panel of the assignment as the options set it; none: another profile.
std::optional<RealtimeOptions> realtime_options(const Options& options);

RealtimeReport realtime_report(const RealtimeOptions& options, const LoadedScene& scene);

/// Adds what the assignment does not draw of the scene.
void check_realtime(const RealtimeOptions& options, LoadedScene& scene);

/// The mistakes that only several options together are, in words that follow "scenefile: "; empty:
/// none.
std::string check_realtime_options(const Options& options, unsigned command);

}  // namespace scenefile::app
