#include "scenefile/geometry/mesh.h"

#include <algorithm>
#include <bit>

namespace scenefile {

namespace {

using Corners = std::array<std::uint32_t, 3>;

bool has_area(const Mesh& mesh, const Corners& c) {
  const glm::vec3& p0 = mesh.positions[c[0]];
  const glm::vec3& p1 = mesh.positions[c[1]];
  const glm::vec3& p2 = mesh.positions[c[2]];
  return p0 != p1 && p1 != p2 && p2 != p0;
}

bool same_place(const Mesh& mesh, const Corners& a, const Corners& b) {
  return mesh.positions[a[0]] == mesh.positions[b[0]] &&
         mesh.positions[a[1]] == mesh.positions[b[1]] &&
         mesh.positions[a[2]] == mesh.positions[b[2]];
}

std::uint64_t place_hash(const Mesh& mesh, const Corners& corners) {
  std::uint64_t hash = 0;
  for (const std::uint32_t corner : corners) {
    const glm::vec3& p = mesh.positions[corner];
    for (int axis = 0; axis < 3; ++axis) {
      // Adding 0.0f makes -0 and 0 equal. The mixing step is the finalizer of MurmurHash3 (Appleby
      // 2011).
      hash ^= std::bit_cast<std::uint32_t>(p[axis] + 0.0f);
      hash = (hash ^ (hash >> 33)) * 0xff51afd7ed558ccdull;
      hash = (hash ^ (hash >> 33)) * 0xc4ceb9fe1a85ec53ull;
    }
  }
  return hash ^ (hash >> 33);
}

// A hash set with open addressing, at most half full.
class PlaceSet {
 public:
  explicit PlaceSet(const Mesh& mesh)
      : mesh_(mesh), slots_(std::bit_ceil(2 * mesh.triangles.size() + 1), mesh_no_index) {}

  // Returns false if a triangle at the same place is already in the set.
  bool insert(std::uint32_t index) {
    const Corners& corners = mesh_.triangles[index];
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = place_hash(mesh_, corners) & mask;
    for (; slots_[slot] != mesh_no_index; slot = (slot + 1) & mask) {
      if (same_place(mesh_, mesh_.triangles[slots_[slot]], corners)) {
        return false;
      }
    }
    slots_[slot] = index;
    return true;
  }

 private:
  const Mesh& mesh_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace

std::vector<std::uint32_t> distinct_triangles(const Mesh& mesh) {
  PlaceSet places(mesh);
  std::vector<std::uint32_t> kept;
  kept.reserve(mesh.triangles.size());
  for (auto i = static_cast<std::uint32_t>(mesh.triangles.size()); i-- > 0;) {
    if (has_area(mesh, mesh.triangles[i]) && places.insert(i)) {
      kept.push_back(i);
    }
  }
  std::reverse(kept.begin(), kept.end());
  return kept;
}

}  // namespace scenefile
