#pragma once
// Pictures of the assignment Realtime. Internal to view.

#include "scenefile/view/picture.h"

namespace scenefile {

/// Same as draw_resolved(), for options with `realtime`.
const PixelSurface* draw_realtime(GlDevice::State& device, Drawing::State& drawing,
                                  const RenderCamera& camera, const DrawOptions& options, int width,
                                  int height, DrawStats& stats);

/// The options with everything disabled that the assignment does not draw.
DrawOptions realtime_draw_options(const DrawOptions& options);

/// The pixel of the scene's viewport, row 0 at the top, that mostly covers the picture's pixel (x,
/// y); false on the background outside of the viewport.
bool realtime_viewport_pixel(Milestone milestone, int width, int height, int& x, int& y);

/// Same as frame_of(), with near and far of the options.
Frame realtime_frame_of(const RenderCamera& camera, const RealtimeOptions& options, int width,
                        int height, const std::vector<WorldObject>& objects);

}  // namespace scenefile
