#include "scenefile/view/expand.h"

#include "scenefile/geometry/mesh.h"

#include <cmath>
#include <optional>

namespace scenefile {

namespace {

// An instance of a group that is still to be expanded.
struct Copy {
  std::uint32_t group = 0;
  std::uint32_t placement = no_index;
  DAffine world_from_group;
  std::size_t next_instance = 0;
};

// An upper bound for the factor by which the map scales lengths.
double stretch(const DAffine& map) {
  const auto square = [](const glm::dvec3& v) { return glm::dot(v, v); };
  return std::sqrt(square(map.linear[0]) + square(map.linear[1]) + square(map.linear[2]));
}

double size_of(const Bounds& box) {
  return glm::length(box.max - box.min);
}

class Expander {
 public:
  Expander(const RenderScene& scene, const Assets& assets, std::uint32_t max_objects)
      : scene_(scene), max_objects_(max_objects) {
    for (const Mesh& mesh : assets.meshes) {
      mesh_boxes_.push_back(bounds(mesh));
    }
    for (const RenderGroup& group : scene.groups) {
      largest_.push_back(largest_in(group));
    }
  }

  /// Larger than any object.
  double largest() const { return scene_.groups.empty() ? 0 : largest_[scene_.root]; }

  /// The objects whose size is at least `least`, stopping if there are too many.
  ExpandedScene expand(double least) {
    result_ = {};
    open_.clear();
    least_ = least;
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
  // An upper bound of the sizes of the objects of a group; a group comes after all that it
  // contains.
  double largest_in(const RenderGroup& group) const {
    double size = 0;
    for (const RenderPrimitive& primitive : group.primitives) {
      if (const auto box = box_of(primitive, DAffine(primitive.group_from_object))) {
        size = std::max(size, size_of(*box));
      }
    }
    for (const RenderInstance& instance : group.instances) {
      size =
          std::max(size, stretch(DAffine(instance.group_from_instance)) * largest_[instance.group]);
    }
    return size;
  }

  void place(const Copy& holder, const RenderInstance& instance) {
    const DAffine world_from_group =
        holder.world_from_group * DAffine(instance.group_from_instance);
    if (stretch(world_from_group) * largest_[instance.group] < least_) {
      return;
    }
    if (result_.placements.size() >= std::size_t{4} * max_objects_) {
      result_.complete = false;
      return;
    }
    result_.placements.push_back({instance.source, holder.placement});
    enter({instance.group, static_cast<std::uint32_t>(result_.placements.size() - 1),
           world_from_group, 0});
  }

  void enter(const Copy& copy) {
    for (const RenderPrimitive& primitive : scene_.groups[copy.group].primitives) {
      add(copy, primitive);
      if (!result_.complete) {
        return;
      }
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
    if (!box || !std::isfinite(size_of(*box)) || size_of(*box) < least_) {
      return;
    }
    if (result_.objects.size() >= max_objects_) {
      result_.complete = false;
      return;
    }
    result_.objects.push_back({Affine(map), glm::vec3(box->min), glm::vec3(box->max),
                               primitive.shape, primitive.mesh, primitive.material});
    result_.names.push_back({primitive.source, copy.placement});
  }

  const RenderScene& scene_;
  std::uint32_t max_objects_;
  std::vector<Bounds> mesh_boxes_;
  std::vector<double> largest_;  // by group
  double least_ = 0;
  std::vector<Copy> open_;
  ExpandedScene result_;
};

}  // namespace

ExpandedScene expand(const RenderScene& scene, const Assets& assets, std::uint32_t max_objects) {
  constexpr int halvings = 40;
  Expander expander(scene, assets, max_objects);
  ExpandedScene result = expander.expand(0);
  if (result.complete) {
    return result;
  }
  // Leaves out the smallest objects, which are the least visible.
  double least = expander.largest();
  for (int i = 0; i < halvings; ++i) {
    least /= 2;
    ExpandedScene some = expander.expand(least);
    if (!some.complete) {
      break;
    }
    if (!some.objects.empty()) {
      result = std::move(some);
      result.complete = false;
      result.largest = true;
    }
  }
  return result;
}

}  // namespace scenefile
