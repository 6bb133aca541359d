#pragma once
// The projection of a picture. Internal to view.

#include "scenefile/view/expand.h"

#include <glm/glm.hpp>

namespace scenefile {

/// A camera with the size of its picture and its clipping planes.
struct Frame {
  RenderCamera camera;
  double tan_x = 1;  ///< half the width of the view at depth 1
  double tan_y = 1;
  int height = 1;  ///< pixels
  double near = 1;
  double far = 2;
  bool parallel = false;  ///< orthographic: tan_x and tan_y are half the size of the view
};

/// Chooses near and far to enclose the visible objects.
Frame frame_of(const RenderCamera& camera, int width, int height,
               const std::vector<WorldObject>& objects);

/// Relative to the eye.
glm::mat4 clip_from_world(const Frame& frame);

/// Conservative: whether the object's bounding box may intersect the view frustum.
bool may_be_seen(const Frame& frame, const WorldObject& object);

/// Whether the near plane does not cut the object; only the front faces of a solid are then
/// visible.
bool is_behind_near(const Frame& frame, const WorldObject& object);

/// Upper bound of the radius of the object's bounding box in the picture, in pixels; infinite if
/// the eye is inside it.
double radius_in_pixels(const Frame& frame, const WorldObject& object);

/// Segments that a round shape of this radius needs to limit the error of its outline to 1/20 of a
/// pixel: r (1 - cos(pi / n)) / 2 < 0.05, because half of the error is outside.
int segments_for(double radius_in_pixels);

/// The same for wireframes, which need space between the lines.
int wires_for(double radius_in_pixels);

}  // namespace scenefile
