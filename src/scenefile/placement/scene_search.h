#pragma once
// Queries about the positions of objects, without an acceleration structure. Internal to the room.

#include "scenefile/asset/load_assets.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/placement/region.h"
#include "scenefile/scene/render_scene.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace scenefile {

/// An object that contains a point.
struct Enclosure {
  const RenderPrimitive* primitive = nullptr;
  bool holds_other = false;  ///< it also contains the other point
};

/// The total work of all queries is bounded; beyond that the answer is "unknown".
class SceneSearch {
 public:
  /// Keeps references. A mesh that is not loaded, or is empty, makes every answer about regions
  /// unknown.
  SceneSearch(const RenderScene& scene, const Assets& assets);

  /// Whether everything that the scene draws is certainly outside of the region.
  bool misses(const Region& region);

  /// Visits the objects that contain the point, until `visit` returns false. A mesh counts if it is
  /// closed, as far as its winding number at the point shows, with its faces outward.
  void enclosing(const glm::dvec3& point, const glm::dvec3& other,
                 const std::function<bool(const Enclosure&)>& visit);

 private:
  bool spend(double work);
  bool encloses(const RenderPrimitive& primitive, const glm::dvec3& point);

  const RenderScene& scene_;
  const Assets& assets_;
  bool meshes_known_;
  std::vector<Bounds> mesh_boxes_;   ///< by mesh, in its space
  std::vector<Bounds> group_boxes_;  ///< by group, in its space
  double budget_ = 5e7;              ///< number of primitives that may be tested
};

}  // namespace scenefile
