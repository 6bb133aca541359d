#pragma once
// Renders to a surface, for windows and images. Internal to view.

#include "scenefile/view/device.h"
#include "scenefile/view/scene_buffers.h"

namespace scenefile {

/// Draws, and returns the surface with the picture, one sample per pixel; null if the device does
/// not support the size. Valid until the next call.
const PixelSurface* draw_resolved(GlDevice::State& device, Drawing::State& drawing,
                                  const RenderCamera& camera, const DrawOptions& options, int width,
                                  int height, DrawStats& stats);

}  // namespace scenefile
