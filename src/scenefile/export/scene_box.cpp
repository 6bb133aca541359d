#include "scenefile/export/scene_box.h"

#include <vector>

namespace scenefile {

Bounds scene_box(const RenderScene& scene, std::span<const Mesh> meshes) {
  std::vector<Bounds> mesh_boxes;
  for (const Mesh& mesh : meshes) {
    mesh_boxes.push_back(bounds(mesh));
  }
  std::vector<Bounds> boxes;  // a group comes after those that it contains
  for (const RenderGroup& group : scene.groups) {
    Bounds box;
    for (const RenderPrimitive& p : group.primitives) {
      const DAffine map(p.group_from_object);
      box = unite(box, p.shape == Shape::mesh ? transform(map, mesh_boxes[p.mesh])
                                              : shape_bounds(p.shape, map));
    }
    for (const RenderInstance& instance : group.instances) {
      box = unite(box, transform(DAffine(instance.group_from_instance), boxes[instance.group]));
    }
    boxes.push_back(box);
  }
  return scene.groups.empty() ? Bounds{} : boxes[scene.root];
}

}  // namespace scenefile
