#include "scenefile/scene/prepare_parts.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace scenefile {

namespace {

// Larger repeats would overflow the int that holds a texel number.
constexpr float max_repeat = 1e4f;

float safe_repeat(float repeat) {
  return std::isfinite(repeat) ? std::clamp(repeat, -max_repeat, max_repeat) : 1;
}

class Mixer {
 public:
  void add(std::uint32_t word) {
    state_ = (state_ ^ word) * 0x9e3779b97f4a7c15u;
    state_ ^= state_ >> 32;
  }
  // Adding 0.0f makes -0 and 0 hash alike, because they are equal.
  void add(float value) { add(std::bit_cast<std::uint32_t>(value + 0.0f)); }
  void add(const glm::vec3& v) {
    add(v.x);
    add(v.y);
    add(v.z);
  }
  void add(const RenderTexture& t) {
    add(t.file);
    add(t.repeat_u);
    add(t.repeat_v);
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0;
};

std::uint32_t number_of(std::unordered_map<std::string, std::uint32_t>& numbers,
                        std::vector<FileReference>& files, const std::string& name,
                        Location location) {
  const auto [at, added] = numbers.emplace(name, static_cast<std::uint32_t>(files.size()));
  if (added) {
    files.push_back({name, location});
  }
  return at->second;
}

std::uint64_t hash_of(const RenderMaterial& m) {
  Mixer mixer;
  for (const glm::vec3* color :
       {&m.ambient, &m.diffuse, &m.specular, &m.reflective, &m.transparent}) {
    mixer.add(*color);
  }
  for (const float value : {m.shininess, m.ior, m.blend}) {
    mixer.add(value);
  }
  mixer.add(m.texture);
  mixer.add(m.bump_map);
  return mixer.value();
}

}  // namespace

MaterialTable::MaterialTable(RenderScene& scene) : scene_(scene) {
  grow();
}

void MaterialTable::grow() {
  std::vector<Slot> old(slots_.empty() ? 16 : slots_.size() * 2, Slot{0, no_index});
  old.swap(slots_);
  const std::size_t mask = slots_.size() - 1;
  for (const Slot& slot : old) {
    if (slot.index != no_index) {
      std::size_t at = slot.hash & mask;
      while (slots_[at].index != no_index) {
        at = (at + 1) & mask;
      }
      slots_[at] = slot;
    }
  }
}

std::uint32_t MaterialTable::number(const RenderMaterial& material) {
  std::vector<RenderMaterial>& materials = scene_.materials;
  if (materials.size() * 2 >= slots_.size()) {
    grow();
  }
  const std::uint64_t hash = hash_of(material);
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = hash & mask;
  for (; slots_[at].index != no_index; at = (at + 1) & mask) {
    if (slots_[at].hash == hash && materials[slots_[at].index] == material) {
      return slots_[at].index;
    }
  }
  slots_[at] = {hash, static_cast<std::uint32_t>(materials.size())};
  materials.push_back(material);
  return slots_[at].index;
}

RenderTexture MaterialTable::texture(const TextureUse& use) {
  if (use.file.empty()) {
    return {};
  }
  return {number_of(texture_numbers_, scene_.texture_files, use.file, use.location),
          safe_repeat(use.repeat_u), safe_repeat(use.repeat_v)};
}

std::uint32_t MaterialTable::material(const Material& material) {
  RenderMaterial ready;
  ready.ambient = material.ambient;
  ready.diffuse = material.diffuse;
  ready.specular = material.specular;
  ready.reflective = material.reflective;
  ready.transparent = material.transparent;
  ready.shininess = material.shininess > 0 ? material.shininess : 0;
  ready.ior = material.ior > 0 ? material.ior : 1;
  ready.blend = material.blend > 0 ? std::min(material.blend, 1.0f) : 0;
  if (material.texture) {
    ready.texture = texture(*material.texture);
  }
  if (material.bump_map) {
    ready.bump_map = texture(*material.bump_map);
  }
  return number(ready);
}

std::uint32_t MaterialTable::mesh(const std::string& file, Location location) {
  return number_of(mesh_numbers_, scene_.mesh_files, file, location);
}

}  // namespace scenefile
