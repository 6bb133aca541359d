#pragma once
// Tests one ray against the objects of a scene. ray_scenes.h finds the candidates; hits are decided
// here, in double precision. Distances always refer to the world-space ray, because transformed
// directions are not normalized.

#include "scenefile/trace/accelerator.h"
#include "scenefile/trace/scene_geometry.h"

#include <array>
#include <limits>

namespace scenefile {

/// A ray that enters more instances than this is abandoned (overlapping nested templates).
inline constexpr std::uint32_t max_instances_entered = 1u << 22;

/// Groups with at most this many objects are searched one by one.
inline constexpr std::size_t max_objects_without_bvh = 3;

/// The state of one ray query.
struct Query {
  const SceneGeometry* geometry = nullptr;
  double t_min = 0;
  /// t of the nearest hit so far, or the end of the ray.
  double best = std::numeric_limits<double>::infinity();
  const Transmission* transmission = nullptr;  ///< for shadow rays through transparent objects
  glm::i64vec3 density{0};
  bool shadow = false;
  bool blocked = false;
  bool overwhelmed = false;
  std::uint32_t entered = 0;

  std::uint32_t depth = 0;
  std::array<std::uint32_t, max_instance_nesting + 1> path;  ///< object in each group on the path

  /// For MeshDistance::of_mesh: a mesh hit at t counts as hit at t * mesh_scale; a mesh that counts
  /// as nearer than `best` is hit before best * reach.
  bool mesh_distances = false;
  double mesh_scale = 1;
  double reach = 1;

  // The nearest hit; for shadow rays only `object`: the one that blocks all light.
  bool found = false;
  std::uint32_t found_depth = 0;
  std::array<std::uint32_t, max_instance_nesting + 1> found_path;
  const Object* object = nullptr;
  Face face = Face::side;
  std::uint32_t triangle = 0;
  double b1 = 0;
  double b2 = 0;
};

/// Whether a hit at t on the object of `path` replaces the one found so far. Among equal ones the
/// last in the file wins (as in the course's references), regardless of the order of tests.
bool improves(const Query& q, double t, std::uint32_t triangle);
/// Stores a hit.
void accept(Query& q, const Object& object, double t);

void search_group(Query& q, const Group& group, const Ray& ray);
/// `ray` is in the space of the group.
void test_object(Query& q, const Group& group, std::uint32_t index, const Ray& ray);

}  // namespace scenefile
