#pragma once
// A reference implementation of the pictures of the assignment Realtime, without OpenGL. It shares
// only the tessellation and the options with the library.

#include "scenefile/asset/image.h"
#include "scenefile/base/realtime.h"
#include "scenefile/scene/render_scene.h"

#include <vector>

namespace scenefile::view_test {

/// Rules that OpenGL leaves to the driver.
struct RasterRules {
  int subpixel_bits = 8;  ///< window coordinates are rounded to this before rasterization
  /// Whether a pixel center on a horizontal edge belongs to the triangle below it or above it.
  bool upper_edges_own = true;
};

struct SoftwarePicture {
  Texture picture;
  /// By pixel: whether the edge of a visible triangle is at most one pixel away.
  std::vector<bool> near_edge;
};

/// Draws no meshes.
SoftwarePicture software_realtime(const RenderScene& scene, const RealtimeOptions& options,
                                  int width, int height, const RasterRules& rules = {});

}  // namespace scenefile::view_test
