#include "scenefile/asset/face_material.h"

#include "scenefile/geometry/mesh.h"

namespace scenefile {

std::vector<std::size_t> triangles_of_materials(const MeshMaterials& mesh) {
  std::vector<std::size_t> counts(mesh.materials.size());
  for (const std::uint32_t material : mesh.of_triangle) {
    if (material != mesh_no_index) {
      ++counts[material];
    }
  }
  return counts;
}

}  // namespace scenefile
