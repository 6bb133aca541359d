#include "scenefile/geometry/mesh.h"

namespace scenefile {

Bounds bounds(const Mesh& mesh) {
  Bounds box;
  for (const auto& corners : mesh.triangles) {
    for (const std::uint32_t corner : corners) {
      box = unite(box, glm::dvec3(mesh.positions[corner]));
    }
  }
  return box;
}

}  // namespace scenefile
