#include "scenefile/export/flat_mesh.h"

#include <array>
#include <cmath>
#include <unordered_map>

namespace scenefile {

namespace {

// A vertex by its indices, for finding duplicates.
struct Key {
  std::uint32_t position, normal, uv;
  std::uint32_t flat;  ///< the triangle whose own normal it has, or mesh_no_index
  friend bool operator==(const Key&, const Key&) = default;
};

struct KeyHash {
  std::size_t operator()(const Key& k) const {
    std::uint64_t h = k.position;
    for (const std::uint32_t part : {k.normal, k.uv, k.flat}) {
      h = (h ^ part) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return static_cast<std::size_t>(h);
  }
};

bool has(const std::vector<std::array<std::uint32_t, 3>>& list, std::size_t triangle) {
  return !list.empty() && list[triangle][0] != mesh_no_index;
}

bool usable(const Mesh& mesh, std::uint32_t normal) {
  const float length = glm::length(mesh.normals[normal]);
  return length > 0 && std::isfinite(length);
}

}  // namespace

FlatMesh flatten(const Mesh& mesh) {
  FlatMesh flat;
  const bool normals = !mesh.triangle_normals.empty();
  const bool uvs = !mesh.triangle_uvs.empty();
  std::unordered_map<Key, std::uint32_t, KeyHash> known;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Key key{mesh.triangles[t][corner], mesh_no_index, mesh_no_index, mesh_no_index};
      if (has(mesh.triangle_uvs, t)) {
        key.uv = mesh.triangle_uvs[t][corner];
      }
      if (has(mesh.triangle_normals, t) && usable(mesh, mesh.triangle_normals[t][corner])) {
        key.normal = mesh.triangle_normals[t][corner];
      } else if (normals) {
        key.flat = static_cast<std::uint32_t>(t);
      }
      const auto [entry, is_new] =
          known.try_emplace(key, static_cast<std::uint32_t>(flat.positions.size()));
      if (is_new) {
        flat.positions.push_back(mesh.positions[key.position]);
        if (normals) {
          flat.normals.emplace_back(
              key.normal != mesh_no_index
                  ? glm::normalize(glm::dvec3(mesh.normals[key.normal]))
                  : surface_at(mesh, static_cast<std::uint32_t>(t), 0, 0, false).normal);
        }
        if (uvs) {
          flat.uvs.push_back(key.uv == mesh_no_index ? glm::vec2(0) : mesh.uvs[key.uv]);
        }
      }
      flat.indices.push_back(entry->second);
    }
  }
  return flat;
}

}  // namespace scenefile
