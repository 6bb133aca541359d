#pragma once
// Findings about what a picture of the scene shows, from geometry and materials. Conservative:
// reports only what is certain.

#include "scenefile/asset/load_assets.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/scene/render_scene.h"

#include <cstdint>
#include <functional>

namespace scenefile {

struct ViewQuestion {
  double aspect = 4;    ///< width / height of the picture, or of the widest one
  bool shadows = true;  ///< whether objects occlude lights
  bool paths = false;   ///< whether surfaces light each other (mode path)
  Location camera;      ///< its place in the file, for messages
  /// The place in the file of a `source` of the scene.
  std::function<Location(std::uint32_t source)> place_of;
};

/// Reports a camera inside an object, nothing in view, lights that cannot reach anything visible,
/// scenes that have only such lights, textures on meshes without texture coordinates, and with
/// `paths` the material that returns the most light, if that is more than it receives. Skips
/// findings that depend on meshes that are not loaded.
/// Takes time linear in the size of the scene, and at most a few seconds. Codes: placement/codes.h.
void check_view(const RenderScene& scene, const Assets& assets, const ViewQuestion& question,
                Diagnostics& diagnostics);

}  // namespace scenefile
