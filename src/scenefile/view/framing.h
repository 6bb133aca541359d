#pragma once
// Where things are in the picture. Internal to the room.

#include "scenefile/view/expand.h"

#include <glm/glm.hpp>

namespace scenefile {

/// A camera for pictures of one size.
struct Frame {
  RenderCamera camera;
  double tan_x = 1;  ///< half the width of the view at depth 1
  double tan_y = 1;
  int height = 1;  ///< pixels
  double near = 1;
  double far = 2;
  bool parallel = false;  ///< all depths look alike: tan_x and tan_y are half the size of the view
};

/// With near and far around what is to be seen of the objects.
Frame frame_of(const RenderCamera& camera, int width, int height,
               const std::vector<WorldObject>& objects);

/// From the world relative to the eye.
glm::mat4 clip_from_world(const Frame& frame);

/// Whether a part of the object's box may be in the picture.
bool may_be_seen(const Frame& frame, const WorldObject& object);

/// Whether the plane of near does not cut the object: of a solid, only the near side is seen.
bool is_behind_near(const Frame& frame, const WorldObject& object);

/// Radius in pixels that the object's box has in the picture at most; infinite around the eye.
double radius_in_pixels(const Frame& frame, const WorldObject& object);

/// Segments that a round shape of this radius needs, so that its outline is off by less than a
/// twentieth of a pixel: r (1 - cos(pi / n)) / 2 < 0.05, where half of the error is outside.
int segments_for(double radius_in_pixels);

/// The same for a drawing of its edges, between which there is to be room.
int wires_for(double radius_in_pixels);

}  // namespace scenefile
