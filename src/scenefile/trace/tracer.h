#pragma once
// Data shared by all rays of a picture, built once.

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

/// Counters of rays.
struct RayCounts {
  std::uint64_t primary = 0;
  std::uint64_t shadow = 0;
  std::uint64_t secondary = 0;
};

struct Tracer {
  Tracer(const TraceScene& traced, const RenderScene& scene, const RenderOptions& options);
  /// Builds the TraceScene too.
  Tracer(const RenderScene& scene, const Assets& assets, const RenderOptions& options);

  /// Rays may only be traced when `complete`; later `limit_reached` if one had to be abandoned.
  RenderStatus status() const;
  /// Includes the lens if that is enabled.
  CameraRays camera() const;
  bool course() const { return options.profile == Profile::course; }
  /// Whether the light is used in this mode: the course's ray caster only uses directional lights.
  bool uses(const RenderLight& light) const;
  /// kt * Ct.
  Color transparency(const RenderMaterial& material) const;

  TraceScene traced;
  const RenderScene& scene;
  const Assets& assets;
  RenderOptions options;   ///< in range
  double transparent = 0;  ///< transparentcoeff of the file or the profile
  Accelerator accelerator;
  Transmission transmission;         ///< by material, for shadow rays
  std::span<const MipMap> mip_maps;  ///< by texture, if lookups are filtered over footprints
};

}  // namespace scenefile
