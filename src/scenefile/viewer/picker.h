#pragma once
// What lies under a pixel, found with the tracer's own accelerator.

#include "scenefile/asset/load_assets.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace scenefile::viewer {

/// Sources (RenderPrimitive, RenderInstance, RenderLight) of what the user has switched off.
using Hidden = std::set<std::uint32_t>;

struct Pick {
  std::uint32_t source = 0;              ///< of the primitive
  std::vector<std::uint32_t> instances;  ///< sources of the copies it lies in, the outermost first
  double distance = 0;                   ///< from the ray's origin, world units
  glm::dvec3 point{0};                   ///< world space
};

/// The ray through a point of the picture: x to the right and y down, both from 0 to 1 over the
/// picture. Unit direction.
Ray ray_through(const RenderCamera& camera, const glm::dvec2& point, double aspect);

class Picker {
 public:
  /// Both must outlive it.
  Picker(const RenderScene& scene, const Assets& assets);
  ~Picker();
  Picker(const Picker&) = delete;
  Picker& operator=(const Picker&) = delete;

  /// The nearest object that is not hidden; nothing too where the scene is too deep or too large to
  /// be searched. `ray` has unit length. Safe from several threads.
  std::optional<Pick> pick(const Ray& ray, const Hidden& hidden = {}) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scenefile::viewer
