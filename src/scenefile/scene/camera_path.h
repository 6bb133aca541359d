#pragma once
// Camera motion: smoothly through views at given times, or around a point.

#include "scenefile/scene/scene.h"

#include <glm/glm.hpp>

#include <optional>
#include <span>
#include <string>

namespace scenefile {

/// The camera at a point in time.
struct CameraView {
  double time = 0;  ///< seconds
  Camera camera;
  std::optional<glm::vec3> focus;  ///< the point to look at, if the view has one
};

/// The camera at a time. `views`: at least one, by increasing time. At the time of a view, its
/// camera; before the first and after the last view, theirs. In between, position and focus (or the
/// rotation, if a view has no focus) follow cubic Hermite curves with continuous speed; height
/// angle, aperture and focal length stay between the values of the two views (Fritsch and Butland,
/// "A Method for Constructing Local Monotone Piecewise Cubic Interpolants", 1984).
Camera camera_at(std::span<const CameraView> views, double time);

/// The camera rotated by `turns` full turns about the axis through `center` parallel to its up
/// vector, to the right as seen from the camera if positive. Unchanged for 0.
Camera camera_around(const Camera& camera, const glm::dvec3& center, double turns);

/// The values of the camera as text, which is the same for two cameras only if all values are: for
/// keys, not for display.
std::string camera_key(const Camera& camera);

}  // namespace scenefile
