#pragma once
// Acceleration structures for objects and triangles: Embree's (embree_scenes.cpp) or our own
// (bvh_scenes.cpp), depending on the build. Both give the same hits, except where a ray passes the
// edge of a triangle within rounding (decision 21).
//
// Each kept group is a scene whose primitives are its objects: analytic shapes, meshes, and
// instances of other groups. Each mesh is a scene too. They only find candidates; search.h decides.

#include "scenefile/trace/search.h"

#include <memory>
#include <string>

namespace scenefile {

class RayScenes {
 public:
  RayScenes();
  ~RayScenes();
  RayScenes(const RayScenes&) = delete;
  RayScenes& operator=(const RayScenes&) = delete;

  /// Whether nothing has failed so far. After a failure, no more scenes are built: if memory runs
  /// out inside a build, Embree's next build in the same thread may hang.
  bool good() const;
  /// Builds the scene of a group from its objects and boxes. `group` must not move afterwards.
  void add(Group& group);
  /// Builds the scene of a mesh: all its triangles, or those listed.
  void add(MeshScene& mesh);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The version of the loaded library, such as "4.3.3"; empty if unknown, "none" without Embree.
std::string embree_version();

/// Tests the objects that the ray may hit; ray and objects are in the space of the group.
void search_group_scene(Query& q, const Group& group, const Ray& ray);

/// Tests the triangles of a mesh object. For shadow rays: whether any is hit.
bool mesh_scene_crossed(Query& q, const Object& object, const Ray& ray);

}  // namespace scenefile
