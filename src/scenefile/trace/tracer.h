#pragma once
// What every ray of one picture shares, made once before the first ray.

#include "scenefile/trace/accelerator.h"
#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/color.h"
#include "scenefile/trace/render.h"
#include "scenefile/trace/texture_lookup.h"
#include "scenefile/trace/trace_scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>

namespace scenefile {

class Recorder;

/// What was traced.
struct RayCounts {
  std::uint64_t primary = 0;
  std::uint64_t shadow = 0;
  std::uint64_t secondary = 0;
  std::uint64_t penumbras = 0;   ///< area lights that were seen in part
  Recorder* recorder = nullptr;  ///< is told everything (recorder.h); null: nobody asks
};

struct Tracer {
  Tracer(const TraceScene& traced, const RenderScene& scene, const RenderOptions& options);
  /// Builds what it needs.
  Tracer(const RenderScene& scene, const Assets& assets, const RenderOptions& options);

  /// Rays may be traced only when `complete`; later `limit_reached` where one had to be given up.
  RenderStatus status() const;
  /// With the lens, where that is switched on.
  CameraRays camera() const;
  bool course() const { return options.profile == Profile::course; }
  /// Smallest t of a ray that starts on a surface at `point` and has a direction of unit length.
  double start_offset(const glm::dvec3& point, double distance) const;
  /// kt * Ct.
  Color transparency(const RenderMaterial& material) const;

  TraceScene traced;
  const RenderScene& scene;
  const Assets& assets;
  RenderOptions options;   ///< in range
  double transparent = 0;  ///< kt, by the file or the profile
  Accelerator accelerator;
  Transmission transmission;          ///< by material, for shadow rays
  std::span<const Pyramid> pyramids;  ///< by texture, where lookups are filtered over footprints
};

}  // namespace scenefile
