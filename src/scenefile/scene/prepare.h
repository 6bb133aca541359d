#pragma once
// From the written scene (scene.h) to the scene to draw (render_scene.h).

#include "scenefile/base/limits.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace scenefile {

enum class SourceKind : std::uint8_t { primitive, instance, light };

/// Where a primitive, instance or light of a render scene came from.
struct Source {
  NodeId node = 0;  ///< in Scene::nodes
  SourceKind kind = SourceKind::primitive;
  std::uint32_t index = 0;  ///< among the primitives or lights of the node

  friend bool operator==(const Source&, const Source&) = default;
};

/// Where the primitive, instance or light is in the file.
Location place_of(const Scene& scene, const Source& source);

/// A render scene with the table that its `source` fields index. Callers that only need the scene
/// can drop the table.
struct Prepared {
  RenderScene scene;
  std::vector<Source> sources;
};

/// Multiplies transforms (in double precision), converts degrees to radians, numbers materials and
/// files, and makes one group of each template in use; all other nodes are folded into the group
/// that contains them. Groups that draw nothing are left out, as are primitives and instances whose
/// transform is not invertible. Values that check() warns about are replaced as its message says,
/// so that a renderer need not check: shininess is not negative, blend is in 0..1, and attenuation
/// never divides by zero.
///
/// Lights: those of each group in the order of the file, before those of its instances; at most
/// limits.lights. An area light is perpendicular to its direction with its width level (along x if
/// the direction is vertical), like a picture on a wall.
///
/// Requires a scene in which check() found no error; for any other scene the result is unspecified
/// but safe to use. Takes time and memory linear in the size of the scene.
Prepared prepare(const Scene& scene, const Limits& limits);

/// The camera as prepare() converts it; a camera that check() rejects becomes the default camera.
RenderCamera ready_camera(const Camera& camera);

/// Whether two scenes are drawn alike: prepare() gives equal results. The sides and direction of
/// area lights may differ by rounding (1 part in 100,000), because their size in world space is a
/// product.
bool same_meaning(const Scene& a, const Scene& b);

}  // namespace scenefile
