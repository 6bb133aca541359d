#include "scenefile/trace/accelerator.h"

#include "scenefile/trace/build_geometry.h"
#include "scenefile/trace/once_flag.h"
#include "scenefile/trace/packet_bvh.h"
#include "scenefile/trace/search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scenefile {

struct Accelerator::Structure {
  RayScenes scenes;
  SceneGeometry geometry;
  Instances instances = Instances::unnamed;
  AcceleratorStatus status = AcceleratorStatus::ready;
  mutable OnceFlag packet_bvh_made;
  mutable PacketBvh packet_bvh;
};

namespace {

constexpr double fixed_point_one = 4294967296.0;  // 2^32 steps per halving
constexpr double black_halvings = Transmission::black / fixed_point_one;

std::int64_t density_of(double factor) {
  const double halvings = factor > 0 ? -std::log2(std::min(factor, 1.0)) : black_halvings;
  return std::llround(std::min(halvings, black_halvings) * fixed_point_one);
}

bool finite(const Ray& ray) {
  const glm::dvec3 sum = ray.origin + ray.direction;
  return std::isfinite(sum.x + sum.y + sum.z);
}

// Searches all objects, or object `only` of the root group. Returns whether a hit was found.
bool search(Query& q, const SceneGeometry& geometry, MeshDistance mesh_distance, const Ray& ray,
            std::atomic<bool>& overwhelmed, std::uint32_t only = no_index) {
  if (geometry.groups.empty() || !finite(ray)) {
    return false;
  }
  q.mesh_distances = mesh_distance == MeshDistance::of_mesh;
  q.reach = q.mesh_distances ? geometry.reach : 1;
  q.geometry = &geometry;
  const Group& root = geometry.groups[geometry.root];
  if (only == no_index) {
    search_group(q, root, ray);
  } else {
    test_object(q, root, only, ray);
  }
  if (q.overwhelmed) {
    overwhelmed.store(true, std::memory_order_relaxed);
  }
  return q.found && !q.overwhelmed;
}

void fill(const Query& q, const SceneGeometry& geometry, const Ray& ray, Hit& hit) {
  const Object& object = *q.object;
  hit.t = q.best;
  hit.shape = object.shape;
  hit.face = q.face;
  hit.mesh = object.kind == ObjectKind::mesh ? object.target : no_index;
  hit.triangle = q.triangle;
  hit.b1 = q.b1;
  hit.b2 = q.b2;
  hit.material = object.material;
  hit.source = object.source;
  hit.object = &object;
  hit.object_from_world = DAffine();
  std::uint32_t group = geometry.root;
  for (std::uint32_t i = 0; i <= q.found_depth; ++i) {
    const Object& step = geometry.groups[group].objects[q.found_path[i]];
    hit.object_from_world = DAffine(step.object_from_group) * hit.object_from_world;
    group = step.target;
  }
  hit.object_point = hit.object_from_world.point(ray.origin + q.best * ray.direction);
}

Query query_of(double t_min, double t_max) {
  Query q;
  q.t_min = t_min;
  q.best = t_max;
  return q;
}

bool has(const std::vector<Object>& objects, ObjectKind kind) {
  return std::any_of(objects.begin(), objects.end(),
                     [&](const Object& object) { return object.kind == kind; });
}

}  // namespace

Accelerator::Accelerator(const RenderScene& scene, const Assets& assets,
                         const AcceleratorOptions& options)
    : mesh_distance_(options.mesh_distance) {
  const auto structure = std::make_shared<Structure>();
  structure->instances = options.instances;
  structure->status =
      build_geometry(scene, assets, options.instances, structure->scenes, structure->geometry);
  structure_ = structure;
}

Accelerator::Accelerator(const Accelerator& shared, MeshDistance mesh_distance)
    : structure_(shared.structure_), mesh_distance_(mesh_distance) {}

Accelerator::~Accelerator() = default;

AcceleratorStatus Accelerator::status() const {
  return structure_->status;
}

bool Accelerator::closest(const Ray& ray, double t_min, double t_max, Hit& hit) const {
  Query q = query_of(t_min, t_max);
  const SceneGeometry& geometry = structure_->geometry;
  if (!search(q, geometry, mesh_distance_, ray, overwhelmed_)) {
    return false;
  }
  fill(q, geometry, ray, hit);
  return true;
}

bool Accelerator::closest_object(const Ray& ray, double t_min, double t_max, Hit& hit) const {
  Query q = query_of(t_min, t_max);
  const SceneGeometry& geometry = structure_->geometry;
  if (!search(q, geometry, mesh_distance_, ray, overwhelmed_)) {
    return false;
  }
  if (q.found_depth == 0 && q.object->kind == ObjectKind::shape) {
    hit.t = q.best;
    hit.face = q.face;
    hit.object = q.object;
  } else {
    fill(q, geometry, ray, hit);
  }
  return true;
}

bool Accelerator::closest_in(std::uint32_t index, const Ray& ray, double t_min, double t_max,
                             Hit& hit) const {
  Query q = query_of(t_min, t_max);
  const SceneGeometry& geometry = structure_->geometry;
  if (!search(q, geometry, mesh_distance_, ray, overwhelmed_, index)) {
    return false;
  }
  fill(q, geometry, ray, hit);
  return true;
}

bool Accelerator::occluded_by(std::uint32_t index, const Ray& ray, double t_min,
                              double t_max) const {
  Query q = query_of(t_min, t_max);
  q.shadow = true;
  search(q, structure_->geometry, mesh_distance_, ray, overwhelmed_, index);
  return q.blocked;
}

std::vector<std::uint32_t> Accelerator::instances_of_closest(const Ray& ray, double t_min,
                                                             double t_max) const {
  Query q = query_of(t_min, t_max);
  const SceneGeometry& geometry = structure_->geometry;
  std::vector<std::uint32_t> names;
  if (structure_->instances == Instances::unnamed ||
      !search(q, geometry, mesh_distance_, ray, overwhelmed_)) {
    return names;
  }
  std::uint32_t index = geometry.root;
  for (std::uint32_t i = 0; i <= q.found_depth; ++i) {
    const Group& group = geometry.groups[index];
    const std::vector<std::uint32_t>& step = group.instances[q.found_path[i]];
    names.insert(names.end(), step.begin(), step.end());
    index = group.objects[q.found_path[i]].target;
  }
  return names;
}

glm::dvec3 Accelerator::transmittance(const Ray& ray, double t_min, double t_max,
                                      const Transmission& transmission,
                                      const void** blocker) const {
  Query q = query_of(t_min, t_max);
  q.shadow = true;
  q.transmission = transmission.all_opaque() ? nullptr : &transmission;
  search(q, structure_->geometry, mesh_distance_, ray, overwhelmed_);
  if (blocker != nullptr && q.object != nullptr) {
    *blocker = q.object;
  }
  return q.blocked ? glm::dvec3(0) : Transmission::factor(q.density);
}

const SceneGeometry& Accelerator::geometry() const {
  return structure_->geometry;
}

const PacketBvh& Accelerator::packet_bvh() const {
  const Structure& structure = *structure_;
  structure.packet_bvh_made([&] {
    if (structure.geometry.groups.empty()) {
      return;
    }
    const Group& root = structure.geometry.groups[structure.geometry.root];
    const bool few = root.objects.size() <= PacketBvh::max_linear_objects &&
                     !has(root.objects, ObjectKind::mesh);
    if (!few && root.boxes.size() == root.objects.size() && root.extent.scale == 1 &&
        !has(root.objects, ObjectKind::instance)) {
      structure.packet_bvh = PacketBvh(root.boxes);
    }
  });
  return structure.packet_bvh;
}

double Accelerator::mesh_reach() const {
  return mesh_distance_ == MeshDistance::of_mesh ? structure_->geometry.reach : 1;
}

bool Accelerator::overwhelmed() const {
  return overwhelmed_.load(std::memory_order_relaxed);
}

bool same_object(const Hit& a, const Hit& b) {
  return a.object == b.object && a.object_from_world == b.object_from_world;
}

Transmission::Transmission(const std::vector<glm::dvec3>& factors, std::vector<bool> opaque_meshes)
    : opaque_meshes_(std::move(opaque_meshes)) {
  densities_.reserve(factors.size());
  for (const glm::dvec3& factor : factors) {
    densities_.emplace_back(density_of(factor.x), density_of(factor.y), density_of(factor.z));
    all_opaque_ = all_opaque_ && blocks(densities_.back());
  }
}

bool Transmission::blocks(const glm::i64vec3& density) {
  return density.x >= black && density.y >= black && density.z >= black;
}

glm::dvec3 Transmission::factor(const glm::i64vec3& density) {
  if (blocks(density)) {
    return glm::dvec3(0);
  }
  const auto one = [](std::int64_t d) {
    const double halvings = static_cast<double>(d) / fixed_point_one;
    return halvings >= black_halvings ? 0.0 : std::exp2(-halvings);
  };
  return {one(density.x), one(density.y), one(density.z)};
}

}  // namespace scenefile
