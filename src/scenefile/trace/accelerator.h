#pragma once
// Rays against a whole scene.

#include "scenefile/asset/load_assets.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/trace/merge_groups.h"

#include <glm/glm.hpp>

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace scenefile {

struct Parts;
class PartTree;

/// Where a ray met a surface.
struct Hit {
  double t = 0;  ///< in lengths of the ray's direction
  Shape shape = Shape::cube;
  Face face = Face::side;         ///< analytic shapes
  std::uint32_t mesh = no_index;  ///< meshes: into RenderScene::mesh_files
  std::uint32_t triangle = 0;     ///< meshes
  double b1 = 0;                  ///< meshes: weight of the triangle's second corner
  double b2 = 0;                  ///< meshes: of its third corner
  std::uint32_t material = 0;     ///< into RenderScene::materials
  std::uint32_t source = 0;       ///< of the primitive
  const void* part = nullptr;     ///< which primitive; instances of it share the value
  DAffine object_from_world;      ///< of the primitive, all instances composed
  glm::dvec3 object_point{0};     ///< the point in object space
};

/// Whether two hits are on one object: the same primitive in the same chain of instances.
bool same_object(const Hit& a, const Hit& b);

/// How much light each material lets through to what lies behind an object of it, as -log2 of the
/// factor in fixed point: sums do not depend on their order.
class Transmission {
 public:
  /// The density of what lets no visible light through.
  static constexpr std::int64_t black = std::int64_t{12} << 32;

  /// `factors`: by material, 0 blocks, 1 and more lets all through.
  explicit Transmission(const std::vector<glm::dvec3>& factors);

  bool all_opaque() const { return all_opaque_; }
  const glm::i64vec3& density(std::uint32_t material) const { return densities_[material]; }
  /// Whether what is left of light after so much density counts as nothing.
  static bool blocks(const glm::i64vec3& density);
  /// The factor of a density.
  static glm::dvec3 factor(const glm::i64vec3& density);

 private:
  std::vector<glm::i64vec3> densities_;
  bool all_opaque_ = true;
};

enum class AcceleratorStatus : std::uint8_t {
  ready,
  too_deep,       ///< instances nest deeper than max_instance_nesting after merging
  out_of_memory,  ///< or any other failure of the ray library
};

/// At which t a ray meets a mesh.
enum class MeshDistance : std::uint8_t {
  of_world,  ///< where it does
  /// At t times the length of the ray's direction in the space of the mesh: nearer by the factor of
  /// the mesh's scale. The course's references have it so. For rays of unit length.
  of_mesh,
};

struct AcceleratorOptions {
  Instances instances = Instances::unnamed;
  MeshDistance mesh_distance = MeshDistance::of_world;
};

/// Instances inside each other that a ray can follow.
inline constexpr std::uint32_t max_instance_nesting = 64;

/// The acceleration structure. Refers to the meshes in `assets`, which must outlive it, but not to
/// the scene. All queries are const, exact in double precision, and safe from several threads; of
/// surfaces at exactly one distance the last in the file is hit, however the structure was built.
class Accelerator {
 public:
  Accelerator(const RenderScene& scene, const Assets& assets,
              const AcceleratorOptions& options = {});
  /// The same structure for another picture, with its own overwhelmed().
  Accelerator(const Accelerator& shared, MeshDistance mesh_distance);
  ~Accelerator();
  Accelerator(const Accelerator&) = delete;
  Accelerator& operator=(const Accelerator&) = delete;

  /// Queries may be made only when `ready`.
  AcceleratorStatus status() const;

  /// The nearest surface at t_min < t < t_max. A ray that is not finite hits nothing.
  bool closest(const Ray& ray, double t_min, double t_max, Hit& hit) const;

  /// The same for those who know parts(): of a shape of the root group t, face and part are told
  /// alone.
  bool closest_part(const Ray& ray, double t_min, double t_max, Hit& hit) const;

  /// The instances that the nearest surface lies in, as their `source`, the outermost first; empty
  /// where they are unnamed or nothing is hit. Searches again.
  std::vector<std::uint32_t> instances_of_closest(const Ray& ray, double t_min, double t_max) const;

  /// Whether any surface lies at t_min < t < t_max.
  bool occluded(const Ray& ray, double t_min, double t_max) const;

  /// What is left of light along the ray at t_min < t < t_max; each object in the way counts once.
  /// `blocker`: becomes the Hit::part of what alone lets none through, if such was met.
  glm::dvec3 transmittance(const Ray& ray, double t_min, double t_max,
                           const Transmission& transmission, const void** blocker = nullptr) const;

  /// What is searched, for those who search it otherwise. Of no groups when it is empty.
  const Parts& parts() const;
  /// The boxes of the root group's parts, for bundles of rays; empty where those are few, very
  /// many, or not all shapes. Made when it is asked for first.
  const PartTree& part_tree() const;

  /// A ray crossed more instances than is sane (templates that overlap without end) and was given
  /// up; pictures made with it are wrong.
  bool overwhelmed() const;

 private:
  struct Structure;
  std::shared_ptr<const Structure> structure_;
  MeshDistance mesh_distance_;
  mutable std::atomic<bool> overwhelmed_{false};
};

}  // namespace scenefile
