#pragma once
// A rendering pass over the objects of a drawing. Internal to view.

#include "scenefile/view/device.h"
#include "scenefile/view/framing.h"

namespace scenefile {

Output output_of(DrawMode mode);

/// Draws the drawing to the bound framebuffer and viewport. For shaded output, the shadow maps must
/// match the options.
DrawStats draw_objects(GlDevice::State& device, Drawing::State& drawing, const Frame& frame,
                       const DrawOptions& options, Output output);

}  // namespace scenefile
