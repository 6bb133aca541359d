#pragma once
// The ray library's structures over parts and triangles.
//
// Each kept group is one scene of it with one user geometry whose primitives are the group's
// parts: analytic shapes, meshes, instances of other groups. The library only finds candidates, in
// single precision and with padded boxes; search.h decides. Its own instances are not used: common
// builds allow one level of them and abort at the second.

#include "scenefile/trace/search.h"

#include <memory>
#include <string>

namespace scenefile {

class EmbreeScenes {
 public:
  EmbreeScenes();
  ~EmbreeScenes();
  EmbreeScenes(const EmbreeScenes&) = delete;
  EmbreeScenes& operator=(const EmbreeScenes&) = delete;

  /// Nothing has failed so far. Once something has, no more are made: when memory runs out at one
  /// place of a build, the library's next build in that thread would wait for ever.
  bool good() const;
  /// Makes the scene of a group, by its parts and boxes. `group` must stay where it is.
  void add(Group& group);
  /// Makes that of a mesh: all triangles, or those that its list names.
  void add(MeshScene& mesh);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Of the library that is loaded, "4.3.3"; empty when it cannot be asked.
std::string embree_version();

/// Offers the query the parts that the ray may meet, ray and parts in the space of the group.
void search_group_scene(Query& q, const Group& group, const Ray& ray);

/// Offers the query the triangles of a mesh part. For shadow rays: whether any is met.
bool mesh_scene_crossed(Query& q, const Part& part, const Ray& ray);

}  // namespace scenefile
