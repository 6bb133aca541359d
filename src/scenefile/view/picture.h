#pragma once
// A picture on its way to a window or an image. Internal to the room.

#include "scenefile/view/device.h"
#include "scenefile/view/scene_buffers.h"

namespace scenefile {

/// Draws, and gives the surface that has the picture, one sample a pixel; null where the device
/// has none of that size. Valid until the next call.
const PixelSurface* draw_resolved(GlDevice::State& device, Drawing::State& drawing,
                                  const RenderCamera& camera, const DrawOptions& options, int width,
                                  int height, DrawStats& stats);

}  // namespace scenefile
