#pragma once
// A pass with what all passes of one picture share already at hand. Internal to the room.

#include "scenefile/trace/picture_state.h"
#include "scenefile/trace/tracer.h"

namespace scenefile {

RenderStatus render_pass(const Tracer& tracer, PictureState& state, const Progress& progress,
                         RenderStats* stats);

}  // namespace scenefile
