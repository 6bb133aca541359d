#include "scenefile/trace/build_geometry.h"

#include "scenefile/placement/bounds.h"
#include "scenefile/trace/packet_bvh.h"

namespace scenefile {

namespace {

class Builder {
 public:
  Builder(const RenderScene& scene, Instances instances, RayScenes& scenes, SceneGeometry& geometry)
      : scene_(scene), instances_(instances), scenes_(scenes), geometry_(geometry) {}

  void run(const FlattenPlan& plan, const Assets& assets) {
    const std::vector<Bounds> boxes = mesh_bounds(scene_, assets);
    geometry_.meshes.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      geometry_.meshes[i].extent.bounds = boxes[i];
      geometry_.meshes[i].mesh = boxes[i].empty() ? nullptr : &assets.meshes[i];
    }
    geometry_.groups.resize(scene_.groups.size());
    geometry_.root = scene_.root;
    for (std::uint32_t g = 0; g < geometry_.groups.size(); ++g) {
      if (plan.kept[g]) {
        build_group(plan, g);
      }
    }
    geometry_.reach = mesh_reach(geometry_.groups, geometry_.root);
  }

 private:
  void build_group(const FlattenPlan& plan, std::uint32_t index) {
    Group& group = geometry_.groups[index];
    const std::vector<FlatObject> flat = flat_objects(scene_, plan, index, instances_);
    group.objects.reserve(flat.size());
    std::vector<Bounds> boxes;
    boxes.reserve(flat.size());
    for (const FlatObject& object : flat) {
      add_object(group, object, boxes);
    }
    Bounds whole;
    for (const Bounds& box : boxes) {
      whole = unite(whole, box);
    }
    group.extent = extent_of(whole);
    if (group.objects.size() > max_objects_without_bvh) {
      add_scene(group, boxes);
    }
  }

  void add_object(Group& group, const FlatObject& flat, std::vector<Bounds>& boxes) {
    Object object;
    Bounds box;
    if (flat.primitive == nullptr) {
      object.kind = ObjectKind::instance;
      object.target = flat.group;
      box = placed_bounds(geometry_.groups[flat.group].extent.bounds, flat.group_from_object);
    } else {
      const RenderPrimitive& primitive = *flat.primitive;
      object.shape = primitive.shape;
      object.material = primitive.material;
      object.source = primitive.source;
      if (primitive.shape == Shape::mesh) {
        object.kind = ObjectKind::mesh;
        object.target = primitive.mesh;
        build_mesh(primitive.mesh);
        box = placed_bounds(geometry_.meshes[primitive.mesh].extent.bounds, flat.group_from_object);
      } else {
        box = shape_bounds(primitive.shape, flat.group_from_object);
      }
    }
    object.object_from_group = Affine(inverse(flat.group_from_object));
    // Flattened transforms may exceed the range of floats.
    if (!box.empty() && invertible(DAffine(object.object_from_group))) {
      group.objects.push_back(object);
      boxes.push_back(box);
      if (instances_ == Instances::named) {
        group.instances.push_back(flat.instances);
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
    if (group.objects.size() > PacketBvh::max_objects) {
      group.boxes = {};
    }
  }

  void build_mesh(std::uint32_t index) {
    MeshScene& mesh = geometry_.meshes[index];
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
  SceneGeometry& geometry_;
};

}  // namespace

AcceleratorStatus build_geometry(const RenderScene& scene, const Assets& assets,
                                 Instances instances, RayScenes& scenes, SceneGeometry& geometry) {
  const FlattenPlan plan = plan_flattening(scene);
  if (plan.nesting > max_instance_nesting) {
    return AcceleratorStatus::too_deep;
  }
  if (!scenes.good()) {
    return AcceleratorStatus::out_of_memory;
  }
  Builder(scene, instances, scenes, geometry).run(plan, assets);
  return scenes.good() ? AcceleratorStatus::ready : AcceleratorStatus::out_of_memory;
}

}  // namespace scenefile
