#pragma once
// The pictures of the assignment Realtime once more, without OpenGL: what the engine is held
// against. It shares the tessellation and the options with the library, nothing else.

#include "scenefile/asset/image.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/view/realtime.h"

#include <vector>

namespace scenefile::view_test {

/// Rules that OpenGL leaves to the driver.
struct RasterRules {
  int subpixel_bits = 8;  ///< to which window coordinates are rounded before rasterization
  /// Which horizontal edges own the pixel centers on them: of the triangle below or above.
  bool upper_edges_own = true;
};

struct SoftwarePicture {
  Texture picture;
  /// By pixel: a visible triangle's edge is at most one pixel away.
  std::vector<bool> near_edge;
};

/// Meshes are left out.
SoftwarePicture software_realtime(const RenderScene& scene, const RealtimeOptions& options,
                                  int width, int height, const RasterRules& rules = {});

}  // namespace scenefile::view_test
