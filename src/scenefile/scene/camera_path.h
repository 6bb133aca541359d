#pragma once
// Cameras that move: smoothly through views at given times, or once around a point.

#include "scenefile/scene/scene.h"

#include <glm/glm.hpp>

#include <optional>
#include <span>

namespace scenefile {

/// Where the camera is at a time.
struct CameraView {
  double time = 0;  ///< seconds
  Camera camera;
  std::optional<glm::vec3> focus;  ///< the point looked at, if that is how the view was given
};

/// The camera at a time. `views`: at least one, in the order of increasing times. At the time of a
/// view it is the view's camera; before the first and after the last it is theirs. Between views
/// position and point looked at (or, where a view has none, the rotation) follow cubic Hermite
/// curves whose speed does not jump; height angle, aperture and focal length stay between the
/// values of the two views (Fritsch and Butland, "A Method for Constructing Local Monotone
/// Piecewise Cubic Interpolants", 1984).
Camera camera_at(std::span<const CameraView> views, double time);

/// The camera turned by `turns` full turns about the axis through `center` along its own up
/// vector, to the right as seen from the camera for turns > 0. `turns` 0: unchanged.
Camera camera_around(const Camera& camera, const glm::dvec3& center, double turns);

}  // namespace scenefile
