#pragma once
// The camera that a person moves. Plain data and pure functions; world units, degrees, and parts of
// the picture's height for distances on the screen.

#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/scene/scene.h"

#include <glm/glm.hpp>

namespace scenefile::viewer {

/// Looks from `position` to `pivot`, which orbiting turns about. `up` stays what the scene says: a
/// view that is saved changes as little of the file as can be.
struct ViewCamera {
  glm::dvec3 position{0, 0, 5};
  glm::dvec3 pivot{0};           ///< never at `position`
  glm::dvec3 up{0, 1, 0};        ///< unit length; the axis of turning to the side
  double height_angle_deg = 45;  ///< full vertical angle of view, in (0, 180)
  float aperture = 0;            ///< of the scene, as Camera has them
  float focal_length = 0;

  friend bool operator==(const ViewCamera&, const ViewCamera&) = default;
};

/// The scene's own camera. The pivot lies `distance` in front of it.
ViewCamera view_of(const Camera& camera, double distance);

/// How far before the camera a pivot is of use: the middle of the box, as far as it lies in front;
/// the length of `look` where the box is empty or behind.
double pivot_distance(const Camera& camera, const Bounds& scene);

/// What a file can say: numbers of six digits at most, `look` reaching to the pivot. Values that
/// are those of `home` to six digits are exactly those.
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

/// Around the pivot; positive takes the camera to the left and down, as if the scene were turned
/// by hand to the right and up. Stops short of looking along `up`.
ViewCamera orbited(const ViewCamera& view, double right_deg, double up_deg);

/// Turns the head: the position stays.
ViewCamera turned(const ViewCamera& view, double right_deg, double up_deg);

/// Moves the picture by parts of its height, so that what lies at the pivot's distance follows the
/// pointer.
ViewCamera panned(const ViewCamera& view, double right, double up);

/// Goes towards `target` until its distance is `factor` of what it was; factors above 1 go away.
/// The direction of view stays.
ViewCamera zoomed(const ViewCamera& view, double factor, const glm::dvec3& target);

/// Moves camera and pivot by a vector in the axes right, above, ahead, in world units.
ViewCamera moved(const ViewCamera& view, const glm::dvec3& by);

/// Goes back or forth until the box fills most of a picture of this aspect, and orbits its middle.
/// An empty box changes nothing.
ViewCamera framing(const ViewCamera& view, const Bounds& box, double aspect);

/// Looks at the pivot from another side.
enum class Side { front, back, right, left, top, bottom };
ViewCamera seen_from(const ViewCamera& view, Side side);

}  // namespace scenefile::viewer
