#pragma once
// Ray queries on a whole scene.

#include "scenefile/asset/load_assets.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/trace/flatten_instances.h"

#include <glm/glm.hpp>

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace scenefile {

struct SceneGeometry;
class PacketBvh;

/// The point where a ray hit a surface.
struct Hit {
  double t = 0;  ///< in units of the length of the ray's direction
  Shape shape = Shape::cube;
  Face face = Face::side;         ///< analytic shapes
  std::uint32_t mesh = no_index;  ///< meshes: into RenderScene::mesh_files
  std::uint32_t triangle = 0;     ///< meshes
  double b1 = 0;                  ///< meshes: barycentric weight of the triangle's second corner
  double b2 = 0;                  ///< meshes: the same for its third corner
  std::uint32_t material = 0;     ///< into RenderScene::materials
  std::uint32_t source = 0;       ///< of the primitive
  const void* object = nullptr;   ///< identifies the primitive; all its instances share the value
  DAffine object_from_world;      ///< of the primitive, including all instances
  glm::dvec3 object_point{0};     ///< the point in object space
};

/// Whether two hits are on the same object: the same primitive in the same chain of instances.
bool same_object(const Hit& a, const Hit& b);

/// The light that each material transmits through an object, as -log2 of the
/// factor in fixed point, so that sums do not depend on their order.
class Transmission {
 public:
  /// A density that blocks all visible light.
  static constexpr std::int64_t black = std::int64_t{12} << 32;

  /// `factors`: by material; 0 blocks all light, 1 or more none. `opaque_meshes`: by mesh; true: it
  /// blocks all light, whatever the material.
  explicit Transmission(const std::vector<glm::dvec3>& factors,
                        std::vector<bool> opaque_meshes = {});

  bool all_opaque() const { return all_opaque_; }
  /// `mesh`: no_index for other shapes.
  glm::i64vec3 density(std::uint32_t material, std::uint32_t mesh = no_index) const {
    return mesh < opaque_meshes_.size() && opaque_meshes_[mesh] ? glm::i64vec3(black)
                                                                : densities_[material];
  }
  /// Whether this density leaves only a negligible amount of light.
  static bool blocks(const glm::i64vec3& density);
  /// The factor for a density.
  static glm::dvec3 factor(const glm::i64vec3& density);

 private:
  std::vector<glm::i64vec3> densities_;
  std::vector<bool> opaque_meshes_;
  bool all_opaque_ = true;
};

enum class AcceleratorStatus : std::uint8_t {
  ready,
  too_deep,       ///< instances are nested deeper than max_instance_nesting after flattening
  out_of_memory,  ///< or another failure of Embree
};

/// How the distance to a mesh is measured.
enum class MeshDistance : std::uint8_t {
  of_world,  ///< the actual distance
  /// t times the length of the ray's direction in the mesh's space: too near by the scale of the
  /// mesh. Reproduces the course's references. For rays of unit length.
  of_mesh,
};

struct AcceleratorOptions {
  Instances instances = Instances::unnamed;
  MeshDistance mesh_distance = MeshDistance::of_world;
};

/// The maximum nesting depth of instances that rays can follow.
inline constexpr std::uint32_t max_instance_nesting = 64;

/// The acceleration structure. Refers to the meshes in `assets`, which must outlive it, but not to
/// the scene. All queries are const, exact in double precision, and thread-safe. If several
/// surfaces are at exactly the same distance, the last one in the file is hit, regardless of the
/// structure.
class Accelerator {
 public:
  Accelerator(const RenderScene& scene, const Assets& assets,
              const AcceleratorOptions& options = {});
  /// Shares the structure with another picture, with a separate overwhelmed().
  Accelerator(const Accelerator& shared, MeshDistance mesh_distance);
  ~Accelerator();
  Accelerator(const Accelerator&) = delete;
  Accelerator& operator=(const Accelerator&) = delete;

  /// Queries are only allowed when `ready`.
  AcceleratorStatus status() const;

  /// The nearest surface at t_min < t < t_max. A ray with a component that is not finite hits
  /// nothing.
  bool closest(const Ray& ray, double t_min, double t_max, Hit& hit) const;

  /// The same for callers that know geometry(): for a shape of the root group, only sets t, face
  /// and object.
  bool closest_object(const Ray& ray, double t_min, double t_max, Hit& hit) const;

  /// The same among object `index` of the root group, a mesh.
  bool closest_in(std::uint32_t index, const Ray& ray, double t_min, double t_max, Hit& hit) const;
  /// Whether object `index` of the root group, a mesh, is hit at t_min < t < t_max.
  bool occluded_by(std::uint32_t index, const Ray& ray, double t_min, double t_max) const;

  /// The `source` of the instances around the nearest surface, outermost first; empty if they are
  /// unnamed or nothing is hit. Repeats the search.
  std::vector<std::uint32_t> instances_of_closest(const Ray& ray, double t_min, double t_max) const;

  /// The fraction of light that remains along the ray at t_min < t < t_max; each object counts
  /// once. `blocker`: if the ray hits an object that lets no light through, set to its Hit::object.
  glm::dvec3 transmittance(const Ray& ray, double t_min, double t_max,
                           const Transmission& transmission, const void** blocker = nullptr) const;

  /// The objects that rays are tested against, for other search algorithms; no groups if the scene
  /// is empty.
  const SceneGeometry& geometry() const;
  /// A BVH of the root group's objects, for packets of rays; empty if there are few or very many
  /// objects, or instances among them. Built at the first call.
  const PacketBvh& packet_bvh() const;
  /// An upper bound of the actual distance of a hit on a mesh, relative to the distance that counts
  /// (MeshDistance); at least 1.
  double mesh_reach() const;

  /// Whether a ray was abandoned because it entered too many instances (deeply nested overlapping
  /// templates); pictures made with it are wrong.
  bool overwhelmed() const;

 private:
  struct Structure;
  std::shared_ptr<const Structure> structure_;
  MeshDistance mesh_distance_;
  mutable std::atomic<bool> overwhelmed_{false};
};

}  // namespace scenefile
