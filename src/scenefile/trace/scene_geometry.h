#pragma once
// What rays are tested against: the kept groups of a scene (flatten_instances.h), as arrays of
// objects.

#include "scenefile/base/affine.h"
#include "scenefile/geometry/mesh.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"

#include <cstdint>
#include <vector>

namespace scenefile {

enum class ObjectKind : std::uint8_t { shape, mesh, instance };

/// One cache line. The transform defines the position of the object; single precision changes it by
/// no more than the precision of the file.
struct Object {
  Affine object_from_group;
  ObjectKind kind = ObjectKind::shape;
  Shape shape = Shape::cube;
  std::uint32_t target = no_index;  ///< mesh or group
  std::uint32_t material = 0;
  std::uint32_t source = 0;
};
static_assert(sizeof(Object) == 64);

struct FloatBox {
  float min[3];
  float max[3];
};

/// The extent of the objects of a group or the triangles of a mesh.
struct Extent {
  Bounds bounds;
  double diagonal = 0;
  double scale = 1;  ///< of the searched copy; a power of two that brings huge scenes into range
};

struct Group {
  std::vector<Object> objects;
  std::vector<FloatBox> boxes;  ///< of the objects, unless there are very many
  std::vector<std::vector<std::uint32_t>> instances;  ///< by object, if instances are named
  Extent extent;
  void* scene = nullptr;  ///< from RayScenes; null for a few objects
};

struct MeshScene {
  const Mesh* mesh = nullptr;
  std::vector<std::uint32_t> triangles;  ///< indices in the mesh, by index in the scene; empty: all
  Extent extent;
  void* scene = nullptr;  ///< from RayScenes
};

/// Everything that rays are tested against.
struct SceneGeometry {
  std::vector<Group> groups;  ///< each group comes after all groups that it contains
  std::vector<MeshScene> meshes;
  std::uint32_t root = 0;
  double reach = 1;  ///< maximum factor by which a vector is longer in the world than in its mesh
};

/// The ray in the space of the object, with the same t.
inline Ray transform(const Affine& to_from, const Ray& ray) {
  const DAffine m(to_from);
  return {m.point(ray.origin), m.vector(ray.direction)};
}

Bounds scaled(const Bounds& box, double by);

/// The extent of the objects or triangles in the box.
Extent extent_of(const Bounds& box);

/// A single-precision bounding box of an object in a group. The padding covers the rounding of the
/// object's transform and of rays in single precision; it is small relative to the object.
FloatBox padded(const Bounds& box, const Bounds& group);

/// Computes SceneGeometry::reach.
double mesh_reach(const std::vector<Group>& groups, std::uint32_t root);

}  // namespace scenefile
