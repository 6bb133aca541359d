// RayScenes with our own BVH, for builds without Embree.

#include "scenefile/geometry/ray_box.h"
#include "scenefile/trace/bvh.h"
#include "scenefile/trace/ray_scenes.h"
#include "scenefile/trace/triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace scenefile {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const Bvh& bvh_of(const void* scene) {
  return *static_cast<const Bvh*>(scene);
}

// The range that Embree supports.
bool searchable(const Ray& ray) {
  const glm::dvec3 size = glm::abs(ray.direction);
  const double largest = std::max({size.x, size.y, size.z});
  return largest > 1e-30 && largest < 1e30;
}

// Scales the ray without changing its t.
Ray scaled_ray(const Ray& ray, double scale) {
  return {scale * ray.origin, scale * ray.direction};
}

std::vector<FloatBox> triangle_boxes(const MeshScene& scene) {
  const Mesh& mesh = *scene.mesh;
  const double scale = scene.extent.scale;
  const Bounds whole = scaled(scene.extent.bounds, scale);
  const std::size_t count =
      scene.triangles.empty() ? mesh.triangles.size() : scene.triangles.size();
  std::vector<FloatBox> boxes;
  boxes.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    Bounds box;
    for (const std::uint32_t corner : mesh.triangles[triangle_of(scene, i)]) {
      box = unite(box, glm::dvec3(mesh.positions[corner]));
    }
    boxes.push_back(padded(scaled(box, scale), whole));
  }
  return boxes;
}

// Whether the line of the ray passes through a triangle, by the side on which it passes each edge.
// An edge shared by two triangles is computed identically for both, so that no ray passes between
// them (compare Davidovic et al., "3D rasterization: a bridge between rasterization and ray
// casting", 2012). Triangles thinner than rounding errors are missed; the tolerance of their
// neighbors covers them.
bool passes_through(const Mesh& mesh, std::uint32_t index, const Ray& ray) {
  const auto& corners = mesh.triangles[index];
  const glm::dvec3 a = glm::dvec3(mesh.positions[corners[0]]) - ray.origin;
  const glm::dvec3 b = glm::dvec3(mesh.positions[corners[1]]) - ray.origin;
  const glm::dvec3 c = glm::dvec3(mesh.positions[corners[2]]) - ray.origin;
  const double bc = glm::dot(ray.direction, glm::cross(b, c));
  const double ca = glm::dot(ray.direction, glm::cross(c, a));
  const double ab = glm::dot(ray.direction, glm::cross(a, b));
  // At an edge both neighbors count; ties are decided elsewhere.
  const double whole = std::abs(bc + ca + ab);
  const double slack = 1e-12 * whole;
  if (std::min({bc, ca, ab}) < -slack && std::max({bc, ca, ab}) > slack) {
    return false;
  }
  const double noise = 1e-14 * (glm::dot(a, a) + glm::dot(b, b) + glm::dot(c, c));
  return whole * whole > noise * noise * glm::dot(ray.direction, ray.direction);
}

// The ray starting near the point where it enters the box, which reduces rounding errors. Returns
// false if it misses the box.
bool start_in_box(const Ray& ray, const Bounds& box, double t_min, double t_max, Ray& near) {
  near = ray;
  if (holds(box, ray.origin)) {
    return true;
  }
  double enter = t_min;
  double leave = t_max;
  const bool meets = clip_to_box(ray, box, enter, leave);
  near.origin = ray.origin + enter * ray.direction;
  return meets;
}

}  // namespace

struct RayScenes::State {
  std::vector<std::unique_ptr<const Bvh>> bvhs;

  void* add(const std::vector<FloatBox>& boxes) {
    bvhs.push_back(std::make_unique<const Bvh>(boxes));
    return const_cast<Bvh*>(bvhs.back().get());
  }
};

RayScenes::RayScenes() : state_(std::make_unique<State>()) {}
RayScenes::~RayScenes() = default;

std::string embree_version() {
  return "none";
}

// If memory runs out, std::bad_alloc is thrown.
bool RayScenes::good() const {
  return true;
}

void RayScenes::add(Group& group) {
  group.scene = state_->add(group.boxes);
}

void RayScenes::add(MeshScene& mesh) {
  mesh.scene = state_->add(triangle_boxes(mesh));
}

void search_group_scene(Query& q, const Group& group, const Ray& ray) {
  if (!searchable(ray)) {
    return;
  }
  const double t_min = q.mesh_distances ? 0 : q.t_min;
  const auto end = [&] { return q.blocked ? -infinity : q.best * q.reach; };
  const auto offer = [&](std::uint32_t index) {
    if (!q.blocked) {
      test_object(q, group, index, ray);
    }
  };
  bvh_of(group.scene).search(scaled_ray(ray, group.extent.scale), t_min, end, offer);
}

bool mesh_scene_crossed(Query& q, const Object& object, const Ray& ray) {
  const MeshScene& scene = q.geometry->meshes[object.target];
  const double t_min = q.t_min / q.mesh_scale;
  Ray near;
  if (!searchable(ray) ||
      !start_in_box(ray, scene.extent.bounds, t_min, q.best / q.mesh_scale, near)) {
    return false;
  }
  bool crossed = false;
  const auto end = [&] { return crossed ? -infinity : q.best / q.mesh_scale; };
  const auto offer = [&](std::uint32_t index) {
    const std::uint32_t triangle = triangle_of(scene, index);
    TriangleHit hit;
    if (crossed || !passes_through(*scene.mesh, triangle, near) ||
        !meet_triangle(*scene.mesh, triangle, ray, hit)) {
      return;
    }
    const double t = hit.t * q.mesh_scale;
    if (q.shadow) {
      crossed = t > q.t_min && t < q.best;
    } else if (t > q.t_min && improves(q, t, triangle)) {
      accept(q, object, t);
      q.triangle = triangle;
      q.b1 = hit.b1;
      q.b2 = hit.b2;
    }
  };
  bvh_of(scene.scene).search(scaled_ray(ray, scene.extent.scale), t_min, end, offer);
  return crossed;
}

}  // namespace scenefile
