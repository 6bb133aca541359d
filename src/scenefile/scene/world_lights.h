#pragma once
// The lights of a scene in world space: one for each copy of the template that holds it.

#include "scenefile/base/affine.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/scene/scene.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace scenefile {

/// A light as a node holds it, and where one copy of that node stands.
struct WorldLight {
  NodeId node = 0;
  std::uint32_t index = 0;  ///< into the lights of the node
  DAffine world_from_node;
};

/// Visits the lights of the root and of all copies of templates in it: those of each tree in the
/// order of the file before those of its instances. Ends early where `visit` returns false. The
/// steps are bounded by the size of the scene plus the number of visits times the nesting, not by
/// the number of copies. Instances that close a loop are left out.
void world_lights(const Scene& scene, const std::function<bool(const WorldLight&)>& visit);

/// The light with its values made safe, in the space that `space_from_node` leads to; nothing when
/// it lights nothing because it has no direction or no finite place.
std::optional<RenderLight> ready_light(const Light& light, const DAffine& space_from_node);

/// Whether a length or direction equals another but for the roundings of a change of space.
bool alike(const glm::vec3& a, const glm::vec3& b);
/// Whether two ready lights are the same. The sides of area lights are so up to roundings and sign,
/// both of which a light that is moved out of its group has; all other values to the bit.
bool alike(const RenderLight& a, const RenderLight& b);

}  // namespace scenefile
