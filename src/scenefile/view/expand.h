#pragma once
// From groups and instances to a flat list of objects in the world. Internal to the room.

#include "scenefile/view/draw.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace scenefile {

/// A primitive in the world.
struct WorldObject {
  Affine world_from_object;
  glm::vec3 box_min{0};  ///< world space
  glm::vec3 box_max{0};
  Shape shape = Shape::cube;
  std::uint32_t mesh = no_index;
  std::uint32_t material = 0;
};

struct ExpandedScene {
  std::vector<WorldObject> objects;  ///< those that can be drawn, in the order of the file
  std::vector<DrawnObject> names;    ///< of the same objects
  std::vector<Placement> placements;
  bool complete = true;  ///< false: objects were left out
  bool largest = false;  ///< those that were left out are the smallest
};

/// At most `max_objects` objects, and four times as many placements: the largest where a size
/// separates them from the others, else the first. Primitives of a group come before its
/// instances.
ExpandedScene expand(const RenderScene& scene, const Assets& assets, std::uint32_t max_objects);

}  // namespace scenefile
