#pragma once
// Expands groups and instances to a flat list of objects in the world. Internal to view.

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
  std::vector<WorldObject> objects;  ///< drawable ones, in the order of the file
  std::vector<DrawnObject> names;    ///< their sources and placements
  std::vector<Placement> placements;
  bool complete = true;  ///< false: objects were left out
  bool largest = false;  ///< the objects that were left out are the smallest
};

/// Expands to at most `max_objects` objects, and four times as many placements: the largest objects
/// if a size threshold can separate them, otherwise the first ones. Primitives of a group come
/// before its instances.
ExpandedScene expand(const RenderScene& scene, const Assets& assets, std::uint32_t max_objects);

}  // namespace scenefile
