#pragma once
// Lines that show where lights and cameras are.

#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace scenefile {

/// In world space.
struct WorldLine {
  glm::dvec3 from{0};
  glm::dvec3 to{0};
};

/// A cross at the light and a line along its direction, or an arrow toward the center of the scene
/// for a directional light. Their size is proportional to `scene`, the box of all objects. A spot
/// light also has its cone, up to the depth of the center of the scene.
std::vector<WorldLine> light_helper(const RenderLight& light, const Bounds& scene);

/// Where the light of a cone ends, and where it begins to fall off.
enum class SpotEdge : std::uint8_t { outer, inner };
/// A point of an edge, at an angle `around` the axis, if the angle from the axis were `angle`; in
/// radians. The inner edge is drawn nearer to the light, so that both differ without a penumbra.
glm::dvec3 cone_point(const RenderLight& light, SpotEdge edge, const Bounds& scene, double angle,
                      double around);
/// An edge as a closed ring. The number of lines is a multiple of 4.
std::vector<glm::dvec3> cone_ring(const RenderLight& light, SpotEdge edge, const Bounds& scene);

/// The view pyramid, with a triangle on the upper side of the picture. `aspect`: width / height.
std::vector<WorldLine> camera_helper(const RenderCamera& camera, double aspect,
                                     const Bounds& scene);

}  // namespace scenefile
