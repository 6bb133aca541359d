#pragma once
// Finds the object at a pixel, using the tracer's acceleration structure.

#include "scenefile/asset/load_assets.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/trace/accelerator.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

namespace scenefile::viewer {

/// Sources (of RenderPrimitive, RenderInstance, RenderLight) that the user has hidden.
using Hidden = std::set<std::uint32_t>;

/// What a picture of the assignment Realtime shows of a ray: hits between two planes, on front
/// faces.
struct PickPlanes {
  glm::dvec3 forward{0, 0, -1};  ///< the view direction, unit length
  double near = 0;
  double far = 0;
};

struct Pick {
  std::uint32_t source = 0;              ///< of the primitive
  std::vector<std::uint32_t> instances;  ///< sources of the instances around it, outermost first
  double distance = 0;                   ///< from the ray's origin, in world units
  glm::dvec3 point{0};                   ///< world space
};

/// The ray through a point of the picture, with x to the right and y down, both from 0 to 1. Unit
/// direction.
Ray ray_through(const RenderCamera& camera, const glm::dvec2& point, double aspect);

class Picker {
 public:
  /// Both must outlive the Picker.
  Picker(const RenderScene& scene, const Assets& assets)
      : accelerator_(scene, assets, {.instances = Instances::named}) {}

  /// The nearest object that is not hidden; nullopt also if the scene is too deep or too large for
  /// the search. The direction of `ray` has unit length. Thread-safe.
  std::optional<Pick> pick(const Ray& ray, const Hidden& hidden = {},
                           const std::optional<PickPlanes>& planes = {}) const;

 private:
  Accelerator accelerator_;
};

}  // namespace scenefile::viewer
