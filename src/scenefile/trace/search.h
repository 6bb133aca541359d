#pragma once
// One ray among the parts of a scene. Which parts it may meet is asked of ray_scenes.h;
// what it meets is decided here, in double precision. Distances are those of
// the world's ray everywhere, because no transformed direction is normalized.

#include "scenefile/trace/accelerator.h"
#include "scenefile/trace/parts.h"

#include <array>
#include <limits>

namespace scenefile {

/// A ray that enters more instances than this is lost in overlapping templates.
inline constexpr std::uint32_t max_instances_entered = 1u << 22;

/// Groups of so few parts are searched one by one.
inline constexpr std::size_t few_parts = 3;

/// What one ray is about.
struct Query {
  const Parts* parts = nullptr;
  double t_min = 0;
  /// t of the nearest hit so far, or the end of the ray.
  double best = std::numeric_limits<double>::infinity();
  const Transmission* transmission = nullptr;  ///< shadow rays through transparent objects
  glm::i64vec3 density{0};
  bool shadow = false;
  bool blocked = false;
  bool overwhelmed = false;
  std::uint32_t entered = 0;

  std::uint32_t depth = 0;
  std::array<std::uint32_t, max_instance_nesting + 1> path;  ///< part in each group on the way

  /// MeshDistance::of_mesh: a mesh that is met at t counts as met at t * mesh_scale, and one that
  /// counts as nearer than `best` is met before best * reach.
  bool mesh_distances = false;
  double mesh_scale = 1;
  double reach = 1;

  // The nearest hit; for shadow rays `part` alone: what lets no light through.
  bool found = false;
  std::uint32_t found_depth = 0;
  std::array<std::uint32_t, max_instance_nesting + 1> found_path;
  const Part* part = nullptr;
  Face face = Face::side;
  std::uint32_t triangle = 0;
  double b1 = 0;
  double b2 = 0;
};

/// Whether a hit at t on what `path` leads to replaces the one found so far. Of equal ones the last
/// in the file wins (the course's references do so), whatever the order in which they are offered.
bool improves(const Query& q, double t, std::uint32_t triangle);
/// Makes it the one found so far.
void accept(Query& q, const Part& part, double t);

void search_group(Query& q, const Group& group, const Ray& ray);
/// `ray` is that of the group.
void test_part(Query& q, const Group& group, std::uint32_t index, const Ray& ray);

}  // namespace scenefile
