#pragma once
// The lights of a scene in world space: one for each instance of the template that contains it.

#include "scenefile/base/affine.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/scene/scene.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace scenefile {

/// A light of a node, and the map of one instance of that node.
struct WorldLight {
  NodeId node = 0;
  std::uint32_t index = 0;  ///< into the lights of the node
  DAffine world_from_node;
};

/// Visits the lights of the root and of all instances in it: those of each tree in the order of the
/// file, before those of its instances. Stops if `visit` returns false. The number of steps is
/// bounded by the size of the scene plus the number of visits times the nesting depth, not by the
/// number of instances. Instances that close a loop are skipped.
void world_lights(const Scene& scene, const std::function<bool(const WorldLight&)>& visit);

/// The light with its values made safe, in the target space of `space_from_node`; nullopt if it has
/// no direction or no finite position, and so lights nothing.
std::optional<RenderLight> ready_light(const Light& light, const DAffine& space_from_node);

/// Whether a length or direction equals another except for the rounding of a change of space.
bool alike(const glm::vec3& a, const glm::vec3& b);
/// Whether two render lights are the same. The edges of area lights may differ by rounding and
/// sign, as happens when a light is moved out of its group; all other values must be identical.
bool alike(const RenderLight& a, const RenderLight& b);

}  // namespace scenefile
