#pragma once
// Questions about where the objects of a scene are, answered without an acceleration structure.
// Internal to the room.

#include "scenefile/asset/load_assets.h"
#include "scenefile/geometry/shapes.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/trace/region.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace scenefile {

/// An object that a point lies inside of.
struct Enclosure {
  const RenderPrimitive* primitive = nullptr;
  bool holds_other = false;  ///< the other point too
};

/// The work of all questions together is bounded; beyond that the answer is that nothing is known.
class SceneSearch {
 public:
  /// Keeps references. A mesh that is not loaded, or is empty, makes every answer about regions
  /// unknown.
  SceneSearch(const RenderScene& scene, const Assets& assets);

  /// Whether all that the scene draws lies outside of the region, for certain.
  bool misses(const Region& region);

  /// Visits the objects that the point lies inside of, until `visit` returns false. A mesh counts
  /// when it is closed, as far as the point can tell, with its faces outward.
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
  double budget_ = 5e7;              ///< in primitives looked at
};

}  // namespace scenefile
