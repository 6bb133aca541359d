#pragma once
// Judges what a picture of the scene would show: findings that need geometry. Everything it says is
// certain; what it cannot tell it leaves unsaid.

#include "scenefile/asset/load_assets.h"
#include "scenefile/base/diagnostics.h"
#include "scenefile/scene/render_scene.h"

#include <cstdint>
#include <functional>

namespace scenefile {

struct ViewQuestion {
  double aspect = 4;    ///< width by height of the picture, or of the widest
  bool shadows = true;  ///< whether objects stop light
  Location camera;      ///< where the file says it, for messages
  /// Where the file says what a `source` of the scene means.
  std::function<Location(std::uint32_t source)> place_of;
};

/// Reports a camera inside an object, nothing in view, lights that cannot light what is seen, and
/// scenes without any other. Meshes that are not loaded leave open what depends on them. Takes time proportional to the size of the scene and at
/// most some seconds. Codes: trace/codes.h.
void check_view(const RenderScene& scene, const Assets& assets, const ViewQuestion& question,
                Diagnostics& diagnostics);

}  // namespace scenefile
