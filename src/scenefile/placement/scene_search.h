#pragma once
// Queries about the positions of objects, without an acceleration structure. Internal to placement.

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

/// The total work of all queries is bounded; once it is used up, the answer is "unknown".
class SceneSearch {
 public:
  /// Keeps references to its arguments. If a mesh is empty or not loaded, all answers about regions
  /// are unknown.
  SceneSearch(const RenderScene& scene, const Assets& assets);

  /// Whether everything that the scene draws is certainly outside the region.
  bool misses(const Region& region);

  /// Visits the objects that contain the point, until `visit` returns false. A mesh contains the
  /// point if its winding number there is 1, as for closed meshes whose faces point outward.
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
  double budget_ = 5e7;              ///< number of primitives that may still be tested
};

}  // namespace scenefile
