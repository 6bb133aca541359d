#pragma once
// Structures over parts and triangles, which say what a ray may meet: Embree's (embree_scenes.cpp)
// or our own (box_scenes.cpp), as the build has it. Both find the same.
//
// Each kept group is one scene, of its parts: analytic shapes, meshes, instances of other groups.
// So is each mesh. They only find candidates; search.h decides.

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

  /// Nothing has failed so far. Once something has, no more are made: when memory runs out at one
  /// place of a build, Embree's next build in that thread would wait for ever.
  bool good() const;
  /// Makes the scene of a group, by its parts and boxes. `group` must stay where it is.
  void add(Group& group);
  /// Makes that of a mesh: all triangles, or those that its list names.
  void add(MeshScene& mesh);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Of the library that is loaded, "4.3.3"; empty when it cannot be asked, "none" without it.
std::string embree_version();

/// Offers the query the parts that the ray may meet, ray and parts in the space of the group.
void search_group_scene(Query& q, const Group& group, const Ray& ray);

/// Offers the query the triangles of a mesh part. For shadow rays: whether any is met.
bool mesh_scene_crossed(Query& q, const Part& part, const Ray& ray);

}  // namespace scenefile
