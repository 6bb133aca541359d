#pragma once
// What rays are searched among: the groups of a scene that are kept (merge_groups.h), as arrays of
// parts.

#include "scenefile/base/affine.h"
#include "scenefile/geometry/mesh.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"

#include <cstdint>
#include <vector>

namespace scenefile {

enum class PartKind : std::uint8_t { shape, mesh, group };

/// One cache line. The transform is the definition of where the part is; single precision moves it
/// by no more than the file's own numbers do.
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

/// Where the parts of a group or the triangles of a mesh are.
struct Extent {
  Bounds bounds;
  double diagonal = 0;
  double scale =
      1;  ///< of the copy that is searched, a power of two: enormous scenes fit its range
};

struct Group {
  std::vector<Part> parts;
  std::vector<FloatBox> boxes;                        ///< of the parts, unless they are very many
  std::vector<std::vector<std::uint32_t>> instances;  ///< by part, where they have names
  Extent extent;
  void* scene = nullptr;  ///< of RayScenes; none for a few parts
};

struct MeshScene {
  const Mesh* mesh = nullptr;
  std::vector<std::uint32_t> triangles;  ///< in the mesh, by that of the scene; empty: all
  Extent extent;
  void* scene = nullptr;  ///< of RayScenes
};

/// All of them.
struct Parts {
  std::vector<Group> groups;  ///< a group stands behind all that it contains
  std::vector<MeshScene> meshes;
  std::uint32_t root = 0;
  double reach = 1;  ///< how much longer than in its mesh a vector may be in the world
};

/// The ray with which the part is tested. Its t are those of the given one.
inline Ray transform(const Affine& to_from, const Ray& ray) {
  const DAffine m(to_from);
  return {m.point(ray.origin), m.vector(ray.direction)};
}

Bounds scaled(const Bounds& box, double by);

/// Of the parts or triangles in the box.
Extent extent_of(const Bounds& box);

/// A single-precision box around what is to be found in a part of a group. The padding covers the
/// rounding of the part's transform and of rays in single precision; it is kept small beside the
/// part itself.
FloatBox padded(const Bounds& box, const Bounds& group);

/// Parts::reach.
double mesh_reach(const std::vector<Group>& groups, std::uint32_t root);

}  // namespace scenefile
