#pragma once
// The parts that prepare() is made of. Internal to the room.

#include "scenefile/base/affine.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/scene/scene.h"

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace scenefile {

/// The light with its values made safe, in the space that `space_from_node` leads to; nothing when
/// it lights nothing because it has no direction or no finite place.
std::optional<RenderLight> ready_light(const Light& light, const DAffine& space_from_node);

/// Whether a length or direction equals another but for the roundings of a change of space.
bool alike(const glm::vec3& a, const glm::vec3& b);
/// Whether two ready lights are the same. The sides of area lights are so up to roundings and sign,
/// both of which a light that is moved out of its group has; all other values to the bit.
bool alike(const RenderLight& a, const RenderLight& b);

/// Numbers materials, textures and meshes, each once.
class MaterialTable {
 public:
  explicit MaterialTable(RenderScene& scene);

  std::uint32_t material(const Material& material);
  std::uint32_t mesh(const std::string& file, Location location);

 private:
  struct Slot {
    std::uint64_t hash;
    std::uint32_t index;  // no_index: free
  };
  using FileNumbers = std::unordered_map<std::string, std::uint32_t>;

  RenderTexture texture(const TextureUse& use);
  std::uint32_t number(const RenderMaterial& material);
  void grow();

  RenderScene& scene_;
  std::vector<Slot> slots_;  // a hash table with open addressing; a power of two of them
  FileNumbers texture_numbers_;
  FileNumbers mesh_numbers_;
};

/// A light in the space of its part.
struct PlacedLight {
  const Light* light;
  DAffine part_from_node;
  std::uint32_t source;
};

/// A copy of another part.
struct PartInstance {
  Affine part_from_instance;
  std::uint32_t part;
  std::uint32_t source;
  bool drawn;  ///< else it counts for the lights in it alone
};

/// One tree of the scene, the root or a template, with all nodes folded into it.
struct Part {
  NodeId head = 0;
  bool drawn = true;
  std::vector<RenderPrimitive> primitives;
  std::vector<PartInstance> instances;
  std::vector<PlacedLight> lights;
};

/// World-space copies of the lights of all parts, part 0 being the world, at most `max_lights`.
std::vector<RenderLight> world_lights(const std::vector<Part>& parts, std::uint32_t max_lights);

}  // namespace scenefile
