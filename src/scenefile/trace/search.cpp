#include "scenefile/trace/search.h"

#include "scenefile/trace/next_up.h"
#include "scenefile/trace/ray_scenes.h"

#include <algorithm>

namespace scenefile {

namespace {

// A shadow ray hit an object.
void obstruct(Query& q, const Object& object) {
  const bool is_mesh = object.kind == ObjectKind::mesh;
  const glm::i64vec3 density =
      q.transmission == nullptr
          ? glm::i64vec3(Transmission::black)
          : q.transmission->density(object.material, is_mesh ? object.target : no_index);
  if (Transmission::blocks(density)) {
    q.blocked = true;
    q.object = &object;
    return;
  }
  q.density += density;
  q.blocked = Transmission::blocks(q.density);
}

void search_mesh(Query& q, const Object& object, const Ray& ray) {
  q.mesh_scale = q.mesh_distances ? glm::length(ray.direction) : 1;
  if (mesh_scene_crossed(q, object, ray)) {
    obstruct(q, object);
  }
}

void test_shape(Query& q, const Object& object, const Ray& ray) {
  // Includes the best t, to decide between equal hits.
  ShapeHit hit;
  const double end = q.shadow ? q.best : next_up<std::int64_t>(q.best);
  if (!intersect(object.shape, ray, q.t_min, end, hit)) {
    return;
  }
  if (q.shadow) {
    obstruct(q, object);
  } else if (improves(q, hit.t, 0)) {
    accept(q, object, hit.t);
    q.face = hit.face;
    q.triangle = 0;
  }
}

void enter_instance(Query& q, const Object& object, const Ray& ray) {
  if (++q.entered > max_instances_entered) {
    q.overwhelmed = true;
    q.blocked = true;
    q.best = -std::numeric_limits<double>::infinity();
    return;
  }
  ++q.depth;
  search_group(q, q.geometry->groups[object.target], ray);
  --q.depth;
}

}  // namespace

bool improves(const Query& q, double t, std::uint32_t triangle) {
  if (t != q.best || !q.found) {
    return t < q.best;
  }
  for (std::uint32_t i = 0; i <= std::min(q.depth, q.found_depth); ++i) {
    if (q.path[i] != q.found_path[i]) {
      return q.path[i] > q.found_path[i];
    }
  }
  return triangle > q.triangle;
}

void accept(Query& q, const Object& object, double t) {
  q.found = true;
  q.best = t;
  q.object = &object;
  q.found_depth = q.depth;
  std::copy_n(q.path.begin(), q.depth + 1, q.found_path.begin());
}

void search_group(Query& q, const Group& group, const Ray& ray) {
  if (group.scene != nullptr) {
    search_group_scene(q, group, ray);
    return;
  }
  for (std::uint32_t i = 0; i < group.objects.size() && !q.blocked; ++i) {
    test_object(q, group, i, ray);
  }
}

void test_object(Query& q, const Group& group, std::uint32_t index, const Ray& ray) {
  const Object& object = group.objects[index];
  const Ray local = transform(object.object_from_group, ray);
  q.path[q.depth] = index;
  switch (object.kind) {
    case ObjectKind::shape:
      return test_shape(q, object, local);
    case ObjectKind::mesh:
      return search_mesh(q, object, local);
    case ObjectKind::instance:
      return enter_instance(q, object, local);
  }
}

}  // namespace scenefile
