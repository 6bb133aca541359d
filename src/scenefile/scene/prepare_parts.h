#pragma once
// The pieces of prepare(). Internal to scene.

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

/// Assigns indices to distinct materials, textures and meshes.
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
  std::vector<Slot> slots_;  // a hash table with open addressing; its size is a power of two
  FileNumbers texture_numbers_;
  FileNumbers mesh_numbers_;
};

/// An instance of another part.
struct PartInstance {
  Affine part_from_instance;
  std::uint32_t part;
  std::uint32_t source;
};

/// A tree of the scene (the root or a template) with all its nodes folded into it.
struct PreparedPart {
  NodeId head = 0;
  std::vector<RenderPrimitive> primitives;
  std::vector<PartInstance> instances;
};

}  // namespace scenefile
