#pragma once
// Pictures of the assignment Realtime. Internal to the room.

#include "scenefile/view/picture.h"

namespace scenefile {

/// As draw_resolved(), where the options ask for the assignment's picture.
const PixelSurface* draw_realtime(GlDevice::State& device, Drawing::State& drawing,
                                  const RenderCamera& camera, const DrawOptions& options, int width,
                                  int height, DrawStats& stats);

/// The options with what the assignment does not draw switched off.
DrawOptions realtime_draw_options(const DrawOptions& options);

/// The pixel of the scene's viewport, row 0 on top, that the picture's pixel (x, y) mostly shows;
/// false on the background beyond the viewport.
bool realtime_viewport_pixel(Milestone milestone, int width, int height, int& x, int& y);

/// frame_of() with the near and far of the options.
Frame realtime_frame_of(const RenderCamera& camera, const RealtimeOptions& options, int width,
                        int height, const std::vector<WorldObject>& objects);

}  // namespace scenefile
