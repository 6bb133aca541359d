#pragma once
// Draws a pass, given what all passes of a picture share. Internal to trace.

#include "scenefile/trace/picture_state.h"
#include "scenefile/trace/tracer.h"

namespace scenefile {

RenderStatus render_pass(const Tracer& tracer, PictureState& state, const Progress& progress,
                         RenderStats* stats);

}  // namespace scenefile
