#include "scenefile/view/expand.h"

#include "scenefile/geometry/mesh.h"

#include <cmath>
#include <optional>

namespace scenefile {

namespace {

// A group on its way to the world.
struct Copy {
  std::uint32_t group = 0;
  std::uint32_t placement = no_index;
  DAffine world_from_group;
  std::size_t next_instance = 0;
};

class Expander {
 public:
  Expander(const RenderScene& scene, const Assets& assets, std::uint32_t max_objects)
      : scene_(scene), assets_(assets), max_objects_(max_objects) {
    for (const Mesh& mesh : assets.meshes) {
      mesh_boxes_.push_back(bounds(mesh));
    }
  }

  ExpandedScene expand() {
    if (!scene_.groups.empty()) {
      enter({scene_.root, no_index, {}, 0});
    }
    while (!open_.empty() && result_.complete) {
      Copy& copy = open_.back();
      const RenderGroup& group = scene_.groups[copy.group];
      if (copy.next_instance == group.instances.size()) {
        open_.pop_back();
        continue;
      }
      const RenderInstance& instance = group.instances[copy.next_instance++];
      place(copy, instance);
    }
    return std::move(result_);
  }

 private:
  void place(const Copy& holder, const RenderInstance& instance) {
    if (result_.placements.size() >= std::size_t{4} * max_objects_) {
      result_.complete = false;
      return;
    }
    result_.placements.push_back({instance.source, holder.placement});
    enter({instance.group, static_cast<std::uint32_t>(result_.placements.size() - 1),
           holder.world_from_group * DAffine(instance.group_from_instance), 0});
  }

  void enter(const Copy& copy) {
    for (const RenderPrimitive& primitive : scene_.groups[copy.group].primitives) {
      if (result_.objects.size() >= max_objects_) {
        result_.complete = false;
        return;
      }
      add(copy, primitive);
    }
    open_.push_back(copy);
  }

  std::optional<Bounds> box_of(const RenderPrimitive& primitive, const DAffine& map) const {
    if (primitive.shape != Shape::mesh) {
      return shape_bounds(primitive.shape, map);
    }
    if (primitive.mesh >= mesh_boxes_.size() || mesh_boxes_[primitive.mesh].empty()) {
      return std::nullopt;
    }
    return transform(map, mesh_boxes_[primitive.mesh]);
  }

  void add(const Copy& copy, const RenderPrimitive& primitive) {
    const DAffine map = copy.world_from_group * DAffine(primitive.group_from_object);
    const std::optional<Bounds> box = box_of(primitive, map);
    if (!box || !std::isfinite(glm::length(box->max - box->min))) {
      return;
    }
    result_.objects.push_back({Affine(map), glm::vec3(box->min), glm::vec3(box->max),
                               primitive.shape, primitive.mesh, primitive.material});
    result_.names.push_back({primitive.source, copy.placement});
  }

  const RenderScene& scene_;
  const Assets& assets_;
  std::uint32_t max_objects_;
  std::vector<Bounds> mesh_boxes_;
  std::vector<Copy> open_;
  ExpandedScene result_;
};

}  // namespace

ExpandedScene expand(const RenderScene& scene, const Assets& assets, std::uint32_t max_objects) {
  return Expander(scene, assets, max_objects).expand();
}

}  // namespace scenefile
