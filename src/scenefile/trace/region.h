#pragma once
// Convex parts of space: what a camera can see at most, what a light can reach at most. Internal to
// the room.

#include "scenefile/scene/render_scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace scenefile {

/// The points p with dot(outward, p) <= distance.
struct HalfSpace {
  glm::dvec3 outward{0};
  double distance = 0;
};

/// What all of the half-spaces have in common; without any, all of space.
using Region = std::vector<HalfSpace>;

/// Holds everything that the camera can see without mirrors, in a picture `aspect` times as wide as
/// high or narrower.
Region view_region(const RenderCamera& camera, double aspect);

/// Holds everything that the light can shine on.
Region lit_region(const RenderLight& light);

}  // namespace scenefile
