#pragma once
// The interactive camera: plain data and pure functions, in world units, degrees, and fractions of
// the picture's height for screen distances.

#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/scene/scene.h"

#include <glm/glm.hpp>

namespace scenefile::viewer {

/// Looks from `position` to `pivot`, the center of orbiting. `up` stays that of the scene, so that
/// saving the view changes as little of the file as possible.
struct ViewCamera {
  glm::dvec3 position{0, 0, 5};
  glm::dvec3 pivot{0};           ///< never at `position`
  glm::dvec3 up{0, 1, 0};        ///< unit length; the axis for turning left and right
  double height_angle_deg = 45;  ///< full vertical angle of view, in (0, 180)
  float aperture = 0;            ///< as in Camera, unchanged
  float focal_length = 0;

  friend bool operator==(const ViewCamera&, const ViewCamera&) = default;
};

/// The scene's camera. The pivot is at `distance` in front of it.
ViewCamera view_of(const Camera& camera, double distance);

/// A useful distance of the pivot: that of the center of the box along the view, or the length of
/// `look` if the box is empty or behind the camera.
double pivot_distance(const Camera& camera, const Bounds& scene);

/// The camera for a file: numbers with at most six digits, `look` reaching to the pivot. Values
/// that equal those of `home` to six digits are exactly those.
Camera camera_of(const ViewCamera& view, const Camera& home);

/// For drawing.
RenderCamera render_camera(const ViewCamera& view);

/// Unit vectors of the view.
struct ViewAxes {
  glm::dvec3 right{1, 0, 0};
  glm::dvec3 above{0, 1, 0};
  glm::dvec3 ahead{0, 0, -1};
};
ViewAxes axes_of(const ViewCamera& view);

/// Orbits around the pivot. Positive angles move the camera to the left and down, as if the scene
/// were turned to the right and up. Stops short of looking along `up`.
ViewCamera orbited(const ViewCamera& view, double right_deg, double up_deg);

/// Turns the view without changing the position.
ViewCamera turned(const ViewCamera& view, double right_deg, double up_deg);

/// Moves the picture by fractions of its height, so that points at the pivot's distance follow the
/// pointer.
ViewCamera panned(const ViewCamera& view, double right, double up);

/// Moves toward `target` until its distance is multiplied by `factor`; factors above 1 move away.
/// The view direction does not change.
ViewCamera zoomed(const ViewCamera& view, double factor, const glm::dvec3& target);

/// Moves camera and pivot by a vector along the axes right, above, ahead, in world units.
ViewCamera moved(const ViewCamera& view, const glm::dvec3& by);

/// Moves along the view until the box fills most of a picture with this aspect ratio, and makes its
/// center the pivot. An empty box changes nothing.
ViewCamera framing(const ViewCamera& view, const Bounds& box, double aspect);

/// Looks at the pivot from another side.
enum class Side { front, back, right, left, top, bottom };
ViewCamera seen_from(const ViewCamera& view, Side side);

}  // namespace scenefile::viewer
