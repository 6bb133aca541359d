#pragma once
// Lamps: the triangles of meshes whose face material emits light (Ke), in world space, and a random
// choice among them.

#include "scenefile/trace/accelerator.h"
#include "scenefile/trace/bvh.h"
#include "scenefile/trace/color.h"
#include "scenefile/trace/scene_geometry.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace scenefile {

/// A value to store: within the range of floats, with room for a few sums.
inline float stored_float(double value) {
  return static_cast<float>(std::min(value, 1e38));
}

/// Relative luminance of linear colors (ITU-R BT.709).
inline double luminance(const Color& c) {
  return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}

/// The color of a map of a face material; white if there is none, or it could not be used.
Color map_color(const Assets& assets, std::uint32_t map, const glm::dvec2& uv);

/// A random point on a lamp.
struct LampPoint {
  glm::dvec3 position{0};
  glm::dvec3 normal{0, 1, 0};  ///< unit length, on the side that emits
  Color emission{0};           ///< radiance
  double density = 0;          ///< per area in world space
  std::uint32_t triangle = 0;  ///< of the lamps
  glm::dvec2 weights{0};       ///< barycentric, of its second and third corner
};

/// Chooses an index with probability weight / sum of weights in constant time (Walker's alias
/// method; Vose, "A Linear Algorithm for Generating Random Numbers with a Given Distribution",
/// 1991).
class AliasTable {
 public:
  AliasTable() = default;
  /// Weights are not negative; their sum is finite and positive.
  explicit AliasTable(const std::vector<double>& weights);

  /// `u` in [0, 1); becomes a new number in [0, 1) that is independent of the choice.
  std::uint32_t choose(double& u) const;
  std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    double keep = 1;
    std::uint32_t other = 0;
  };
  std::vector<Entry> entries_;
};

/// Chooses triangles by their power: area times luminance of the mean emission. Of lamps at the
/// same place that face the same way, only the last one is seen, by paths and by light samples.
class Lamps {
 public:
  Lamps() = default;
  /// The lamps that rays can hit. Refers to the assets. Scenes with extremely many are treated as
  /// having none: paths then only find them by chance.
  Lamps(const SceneGeometry& geometry, const Assets& assets);

  bool empty() const { return triangles_.empty(); }
  std::size_t size() const { return triangles_.size(); }
  /// The area of a triangle in world space.
  double area(std::size_t triangle) const { return areas_[triangle]; }
  /// The radiance in the middle of a triangle.
  Color emission(std::size_t triangle) const;
  /// `point` is uniform in the unit square.
  LampPoint sample(glm::dvec2 point) const;
  /// The lamp that is seen at this point, which was sampled, by a ray of unit length; its density
  /// is that of all lamps there.
  LampPoint seen(const Ray& ray, double distance, const LampPoint& lamp) const;
  /// The density of sample() for a point that a ray hit, by all lamps there that face the ray; 0 if
  /// there are none. Otherwise the hit becomes one on the lamp that is seen.
  double reveal(const Ray& ray, Hit& hit) const;
  /// From now on, points are uniform in the parallelograms of two edges of triangles, with the
  /// density of the triangles: as in programs that forget the half outside of them. Weights of
  /// corners may then be negative.
  void cover_parallelograms() { parallelograms_ = true; }
  /// The density, per area, of sample() for a point on a triangle with a face material; 0: not a
  /// lamp.
  double density(std::uint32_t mesh, std::uint32_t material) const;

 private:
  struct Place {
    DAffine world_from_object;
    DAffine object_from_world;
    std::uint32_t mesh = 0;
    std::uint32_t source = 0;  ///< of the primitive
  };
  struct Triangle {
    std::uint32_t place = 0;
    std::uint32_t index = 0;  ///< in the mesh
  };

  void find_places(const SceneGeometry& geometry);
  void add_triangles(const SceneGeometry& geometry);
  // Whether lamps that face the same way are at the same place.
  bool find_overlap() const;
  double density(const Triangle& triangle) const;
  LampPoint point_on(std::uint32_t triangle, const glm::dvec2& weights) const;
  // Calls visit(index, weights) for the triangles but `known` that the ray meets from the front at
  // t, within rounding.
  template <typename Visit>
  void visit_at(const Ray& ray, double t, std::uint32_t known, const Visit& visit) const;

  const Assets* assets_ = nullptr;
  std::vector<std::vector<double>> radiance_;  ///< by mesh and face material; mean luminance
  std::vector<Place> places_;
  std::vector<Triangle> triangles_;
  std::vector<double> areas_;
  AliasTable table_;
  std::optional<Bvh> boxes_;  ///< of triangles
  Extent extent_;             ///< of all of them
  double power_ = 0;
  bool overlap_ = false;
  bool parallelograms_ = false;
};

}  // namespace scenefile
