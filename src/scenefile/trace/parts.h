#pragma once
// What rays are tested against: the kept groups of a scene (merge_groups.h), as arrays of parts.

#include "scenefile/base/affine.h"
#include "scenefile/geometry/mesh.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"

#include <cstdint>
#include <vector>

namespace scenefile {

enum class PartKind : std::uint8_t { shape, mesh, group };

/// One cache line. The transform defines the position of the part; single precision changes it by
/// no more than the precision of the file.
struct Part {
  Affine part_from_group;
  PartKind kind = PartKind::shape;
  Shape shape = Shape::cube;
  std::uint32_t target = no_index;  ///< mesh or group
  std::uint32_t material = 0;
  std::uint32_t source = 0;
};
static_assert(sizeof(Part) == 64);

struct FloatBox {
  float min[3];
  float max[3];
};

/// The extent of the parts of a group or the triangles of a mesh.
struct Extent {
  Bounds bounds;
  double diagonal = 0;
  double scale = 1;  ///< of the searched copy; a power of two that brings huge scenes into range
};

struct Group {
  std::vector<Part> parts;
  std::vector<FloatBox> boxes;                        ///< of the parts, unless there are very many
  std::vector<std::vector<std::uint32_t>> instances;  ///< by part, if instances are named
  Extent extent;
  void* scene = nullptr;  ///< from RayScenes; null for a few parts
};

struct MeshScene {
  const Mesh* mesh = nullptr;
  std::vector<std::uint32_t> triangles;  ///< indices in the mesh, by index in the scene; empty: all
  Extent extent;
  void* scene = nullptr;  ///< from RayScenes
};

/// Everything that rays are tested against.
struct Parts {
  std::vector<Group> groups;  ///< each group comes after all groups that it contains
  std::vector<MeshScene> meshes;
  std::uint32_t root = 0;
  double reach = 1;  ///< maximum factor by which a vector is longer in the world than in its mesh
};

/// The ray in the space of the part, with the same t.
inline Ray transform(const Affine& to_from, const Ray& ray) {
  const DAffine m(to_from);
  return {m.point(ray.origin), m.vector(ray.direction)};
}

Bounds scaled(const Bounds& box, double by);

/// The extent of the parts or triangles in the box.
Extent extent_of(const Bounds& box);

/// A single-precision bounding box of a part in a group. The padding covers the rounding of the
/// part's transform and of rays in single precision; it is small relative to the part.
FloatBox padded(const Bounds& box, const Bounds& group);

/// Computes Parts::reach.
double mesh_reach(const std::vector<Group>& groups, std::uint32_t root);

}  // namespace scenefile
