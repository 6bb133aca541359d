#include "scenefile/trace/build_parts.h"

#include "scenefile/placement/bounds.h"
#include "scenefile/trace/part_tree.h"

namespace scenefile {

namespace {

class Builder {
 public:
  Builder(const RenderScene& scene, Instances instances, RayScenes& scenes, Parts& parts)
      : scene_(scene), instances_(instances), scenes_(scenes), parts_(parts) {}

  void run(const MergePlan& plan, const Assets& assets) {
    const std::vector<Bounds> boxes = mesh_bounds(scene_, assets);
    parts_.meshes.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      parts_.meshes[i].extent.bounds = boxes[i];
      parts_.meshes[i].mesh = boxes[i].empty() ? nullptr : &assets.meshes[i];
    }
    parts_.groups.resize(scene_.groups.size());
    parts_.root = scene_.root;
    for (std::uint32_t g = 0; g < parts_.groups.size(); ++g) {
      if (plan.kept[g]) {
        build_group(plan, g);
      }
    }
    parts_.reach = mesh_reach(parts_.groups, parts_.root);
  }

 private:
  void build_group(const MergePlan& plan, std::uint32_t index) {
    Group& group = parts_.groups[index];
    const std::vector<MergedPart> merged = merged_parts(scene_, plan, index, instances_);
    group.parts.reserve(merged.size());
    std::vector<Bounds> boxes;
    boxes.reserve(merged.size());
    for (const MergedPart& part : merged) {
      add_part(group, part, boxes);
    }
    Bounds whole;
    for (const Bounds& box : boxes) {
      whole = unite(whole, box);
    }
    group.extent = extent_of(whole);
    if (group.parts.size() > max_parts_without_bvh) {
      add_scene(group, boxes);
    }
  }

  void add_part(Group& group, const MergedPart& merged, std::vector<Bounds>& boxes) {
    Part part;
    Bounds box;
    if (merged.primitive == nullptr) {
      part.kind = PartKind::group;
      part.target = merged.group;
      box = placed_bounds(parts_.groups[merged.group].extent.bounds, merged.group_from_part);
    } else {
      const RenderPrimitive& primitive = *merged.primitive;
      part.shape = primitive.shape;
      part.material = primitive.material;
      part.source = primitive.source;
      if (primitive.shape == Shape::mesh) {
        part.kind = PartKind::mesh;
        part.target = primitive.mesh;
        build_mesh(primitive.mesh);
        box = placed_bounds(parts_.meshes[primitive.mesh].extent.bounds, merged.group_from_part);
      } else {
        box = shape_bounds(primitive.shape, merged.group_from_part);
      }
    }
    part.part_from_group = Affine(inverse(merged.group_from_part));
    // Merged transforms may exceed the range of floats.
    if (!box.empty() && invertible(DAffine(part.part_from_group))) {
      group.parts.push_back(part);
      boxes.push_back(box);
      if (instances_ == Instances::named) {
        group.instances.push_back(merged.instances);
      }
    }
  }

  void add_scene(Group& group, const std::vector<Bounds>& boxes) {
    const double scale = group.extent.scale;
    const Bounds whole = scaled(group.extent.bounds, scale);
    group.boxes.reserve(boxes.size());
    for (const Bounds& box : boxes) {
      group.boxes.push_back(padded(scaled(box, scale), whole));
    }
    scenes_.add(group);
    if (group.parts.size() > PartTree::max_parts) {
      group.boxes = {};
    }
  }

  void build_mesh(std::uint32_t index) {
    MeshScene& mesh = parts_.meshes[index];
    if (mesh.mesh == nullptr || mesh.scene != nullptr) {
      return;
    }
    // Without duplicates: a file can repeat a triangle so often that every ray takes seconds.
    std::vector<std::uint32_t> distinct = distinct_triangles(*mesh.mesh);
    if (distinct.empty()) {
      mesh = {};
      return;
    }
    if (distinct.size() < mesh.mesh->triangles.size()) {
      mesh.triangles = std::move(distinct);
    }
    mesh.extent = extent_of(mesh.extent.bounds);
    scenes_.add(mesh);
  }

  const RenderScene& scene_;
  Instances instances_;
  RayScenes& scenes_;
  Parts& parts_;
};

}  // namespace

AcceleratorStatus build_parts(const RenderScene& scene, const Assets& assets, Instances instances,
                              RayScenes& scenes, Parts& parts) {
  const MergePlan plan = plan_merge(scene);
  if (plan.nesting > max_instance_nesting) {
    return AcceleratorStatus::too_deep;
  }
  if (!scenes.good()) {
    return AcceleratorStatus::out_of_memory;
  }
  Builder(scene, instances, scenes, parts).run(plan, assets);
  return scenes.good() ? AcceleratorStatus::ready : AcceleratorStatus::out_of_memory;
}

}  // namespace scenefile
