#pragma once
// Lines that show where lights and cameras are.

#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace scenefile {

/// In world space.
struct WorldLine {
  glm::dvec3 from{0};
  glm::dvec3 to{0};
};

/// A cross at the light and a line along its direction, or an arrow toward the center of the scene
/// for a directional light. Their size is proportional to `scene`, the box of all objects.
std::vector<WorldLine> light_helper(const RenderLight& light, const Bounds& scene);

/// The view pyramid, with a triangle on the upper side of the picture. `aspect`: width / height.
std::vector<WorldLine> camera_helper(const RenderCamera& camera, double aspect,
                                     const Bounds& scene);

}  // namespace scenefile
