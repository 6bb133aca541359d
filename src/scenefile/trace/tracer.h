#pragma once
// What every ray of one picture shares, made once before the first ray.

#include "scenefile/trace/accelerator.h"
#include "scenefile/trace/render.h"
#include "scenefile/trace/texture_lookup.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace scenefile {

/// Linear red, green, blue.
using Color = glm::dvec3;

/// What was traced.
struct RayCounts {
  std::uint64_t primary = 0;
  std::uint64_t shadow = 0;
  std::uint64_t secondary = 0;
  std::uint64_t penumbras = 0;  ///< area lights that were seen in part
};

struct Tracer {
  Tracer(const RenderScene& scene, const Assets& assets, const RenderOptions& options);

  bool course() const { return options.profile == Profile::course; }
  /// Smallest t of a ray that starts on a surface at `point` and has a direction of unit length.
  double start_offset(const glm::dvec3& point, double distance) const;
  /// kt * Ct.
  Color transparency(const RenderMaterial& material) const;

  const RenderScene& scene;
  const Assets& assets;
  RenderOptions options;
  double transparent = 0;  ///< kt, by the file or the profile
  Accelerator accelerator;
  Transmission transmission;      ///< by material, for shadow rays
  std::vector<Pyramid> pyramids;  ///< by texture, where lookups are filtered over footprints
};

}  // namespace scenefile
