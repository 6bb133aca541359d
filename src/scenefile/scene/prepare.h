#pragma once
// From the written scene to the ready one.

#include "scenefile/base/limits.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/scene/scene.h"

#include <string>
#include <vector>

namespace scenefile {

/// Where a ready primitive, instance or light came from.
struct Source {
  NodeId node = 0;    ///< in Scene::nodes
  Location location;  ///< of the object or light in the file
};

/// A ready scene with the table that its `source` fields index. The table stays behind when the
/// scene alone is wanted.
struct Prepared {
  RenderScene scene;
  std::vector<Source> sources;
};

/// Multiplies transforms (in double precision), turns degrees to radians, numbers materials and
/// files, makes one group of each template that is used; all other nodes are folded into the group
/// that they stand in. Groups that draw nothing are left out, as are primitives and instances whose
/// transform is not invertible. Values that check() warns of become what its message says, so that
/// a renderer need not look: no negative shininess, blend in 0..1, no attenuation by zero.
///
/// Lights: those of each group in the order of the file before those of its instances; at most
/// limits.lights. An area light lies across its direction with its width level (along x where the
/// direction is vertical), as a picture hangs on a wall.
///
/// Expects a scene in which check() found no error; for any other the result is unspecified but
/// safe to use. Takes time and memory proportional to the size of the scene.
Prepared prepare(const Scene& scene, const Limits& limits);

/// The camera that prepare() makes of a written one; what check() refuses becomes the default.
RenderCamera ready_camera(const Camera& camera);

/// Names from the root (or template) down to the node, joined by '/'; nameless nodes appear as
/// `#k`, their place among their siblings from 1. For messages.
std::string node_path(const Scene& scene, NodeId node);

/// Whether two scenes are drawn alike: equal results of prepare(), but for roundings (a part in
/// 100,000) in the sides and the direction of area lights, whose size in the world is a product.
bool same_meaning(const Scene& a, const Scene& b);

}  // namespace scenefile
