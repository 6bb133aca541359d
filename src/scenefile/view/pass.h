#pragma once
// One walk over the objects of a drawing. Internal to the room.

#include "scenefile/view/device.h"
#include "scenefile/view/framing.h"

namespace scenefile {

Output output_of(DrawMode mode);

/// Draws what the frame shows of the drawing onto the framebuffer and viewport that are bound.
/// The shadow maps must be those of the options where `output` is shaded.
DrawStats draw_objects(GlDevice::State& device, Drawing::State& drawing, const Frame& frame,
                       const DrawOptions& options, Output output);

}  // namespace scenefile
