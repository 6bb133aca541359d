#include "scenefile/placement/bounds.h"

namespace scenefile {

std::vector<Bounds> mesh_bounds(const RenderScene& scene, const Assets& assets) {
  std::vector<Bounds> result(scene.mesh_files.size());
  for (std::size_t i = 0; i < result.size() && i < assets.meshes.size(); ++i) {
    if (!assets.meshes[i].triangles.empty()) {
      result[i] = bounds(assets.meshes[i]);
    }
  }
  return result;
}

Bounds placed_bounds(const Bounds& box, const DAffine& to_from) {
  return box.empty() ? Bounds{} : transform(to_from, box);
}

std::vector<Bounds> group_bounds(const RenderScene& scene, const std::vector<Bounds>& meshes) {
  std::vector<Bounds> groups;
  groups.reserve(scene.groups.size());
  for (const RenderGroup& group : scene.groups) {
    Bounds box;
    for (const RenderPrimitive& primitive : group.primitives) {
      const DAffine place(primitive.group_from_object);
      box = unite(box, primitive.shape == Shape::mesh ? placed_bounds(meshes[primitive.mesh], place)
                                                      : shape_bounds(primitive.shape, place));
    }
    for (const RenderInstance& instance : group.instances) {
      box =
          unite(box, placed_bounds(groups[instance.group], DAffine(instance.group_from_instance)));
    }
    groups.push_back(box);
  }
  return groups;
}

Bounds scene_bounds(const RenderScene& scene, const Assets& assets) {
  const std::vector<Bounds> groups = group_bounds(scene, mesh_bounds(scene, assets));
  return groups.empty() ? Bounds{} : groups[scene.root];
}

}  // namespace scenefile
