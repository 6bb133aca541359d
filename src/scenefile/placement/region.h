#pragma once
// Convex regions that enclose what a camera can see or a light can reach. Internal to placement.

#include "scenefile/scene/render_scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace scenefile {

/// The points p with dot(outward, p) <= distance.
struct HalfSpace {
  glm::dvec3 outward{0};
  double distance = 0;
};

/// The intersection of half-spaces; if there are none, all of space.
using Region = std::vector<HalfSpace>;

/// Encloses everything that the camera can see without mirrors, in a picture with at most this
/// aspect ratio.
Region view_region(const RenderCamera& camera, double aspect);

/// Encloses everything that the light can reach.
Region lit_region(const RenderLight& light);

}  // namespace scenefile
