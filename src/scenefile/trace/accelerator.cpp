#include "scenefile/trace/accelerator.h"

#include "scenefile/trace/build_parts.h"
#include "scenefile/trace/search.h"

#include <atomic>
#include <cmath>

namespace scenefile {

struct Accelerator::Impl {
  EmbreeScenes scenes;
  Parts parts;
  AcceleratorOptions options;
  AcceleratorStatus status = AcceleratorStatus::ready;
  mutable std::atomic<bool> overwhelmed{false};

  bool search(Query& q, const Ray& ray) const {
    const glm::dvec3 sum = ray.origin + ray.direction;
    if (parts.groups.empty() || !std::isfinite(sum.x + sum.y + sum.z)) {
      return false;
    }
    q.mesh_distances = options.mesh_distance == MeshDistance::of_mesh;
    q.reach = parts.reach;
    q.parts = &parts;
    search_group(q, parts.groups[parts.root], ray);
    if (q.overwhelmed) {
      overwhelmed.store(true, std::memory_order_relaxed);
    }
    return q.found && !q.overwhelmed;
  }

  bool closest(Query& q, const Ray& ray, double t_min, double t_max) const {
    q.t_min = t_min;
    q.best = t_max;
    return search(q, ray);
  }

  void fill(const Query& q, const Ray& ray, Hit& hit) const {
    const Part& part = *q.part;
    hit.t = q.best;
    hit.shape = part.shape;
    hit.face = q.face;
    hit.mesh = part.kind == PartKind::mesh ? part.target : no_index;
    hit.triangle = q.triangle;
    hit.b1 = q.b1;
    hit.b2 = q.b2;
    hit.material = part.material;
    hit.source = part.source;
    hit.part = &part;
    hit.object_from_world = DAffine();
    std::uint32_t group = parts.root;
    for (std::uint32_t i = 0; i <= q.found_depth; ++i) {
      const Part& step = parts.groups[group].parts[q.found_path[i]];
      hit.object_from_world = DAffine(step.part_from_group) * hit.object_from_world;
      group = step.target;
    }
    hit.object_point = hit.object_from_world.point(ray.origin + q.best * ray.direction);
  }
};

Accelerator::Accelerator(const RenderScene& scene, const Assets& assets,
                         const AcceleratorOptions& options)
    : impl_(std::make_unique<Impl>()) {
  impl_->options = options;
  impl_->status = build_parts(scene, assets, options, impl_->scenes, impl_->parts);
}

Accelerator::~Accelerator() = default;

AcceleratorStatus Accelerator::status() const {
  return impl_->status;
}

bool Accelerator::closest(const Ray& ray, double t_min, double t_max, Hit& hit) const {
  Query q;
  if (!impl_->closest(q, ray, t_min, t_max)) {
    return false;
  }
  impl_->fill(q, ray, hit);
  return true;
}

bool Accelerator::closest_part(const Ray& ray, double t_min, double t_max, Hit& hit) const {
  Query q;
  if (!impl_->closest(q, ray, t_min, t_max)) {
    return false;
  }
  if (q.found_depth == 0 && q.part->kind == PartKind::shape) {
    hit.t = q.best;
    hit.face = q.face;
    hit.part = q.part;
  } else {
    impl_->fill(q, ray, hit);
  }
  return true;
}

std::vector<std::uint32_t> Accelerator::instances_of_closest(const Ray& ray, double t_min,
                                                             double t_max) const {
  Query q;
  std::vector<std::uint32_t> names;
  if (impl_->options.instances == Instances::unnamed || !impl_->closest(q, ray, t_min, t_max)) {
    return names;
  }
  std::uint32_t index = impl_->parts.root;
  for (std::uint32_t i = 0; i <= q.found_depth; ++i) {
    const Group& group = impl_->parts.groups[index];
    const std::vector<std::uint32_t>& step = group.instances[q.found_path[i]];
    names.insert(names.end(), step.begin(), step.end());
    index = group.parts[q.found_path[i]].target;
  }
  return names;
}

bool Accelerator::occluded(const Ray& ray, double t_min, double t_max) const {
  Query q;
  q.t_min = t_min;
  q.best = t_max;
  q.shadow = true;
  impl_->search(q, ray);
  return q.blocked;
}

glm::dvec3 Accelerator::transmittance(const Ray& ray, double t_min, double t_max,
                                      const Transmission& transmission,
                                      const void** blocker) const {
  Query q;
  q.t_min = t_min;
  q.best = t_max;
  q.shadow = true;
  q.transmission = transmission.all_opaque() ? nullptr : &transmission;
  impl_->search(q, ray);
  if (blocker != nullptr && q.part != nullptr) {
    *blocker = q.part;
  }
  return q.blocked ? glm::dvec3(0) : Transmission::factor(q.density);
}

const Parts& Accelerator::parts() const {
  return impl_->parts;
}

bool Accelerator::overwhelmed() const {
  return impl_->overwhelmed.load(std::memory_order_relaxed);
}

bool same_object(const Hit& a, const Hit& b) {
  return a.part == b.part && a.object_from_world == b.object_from_world;
}

}  // namespace scenefile
