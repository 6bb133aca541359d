#pragma once
// Draws a pass, given the data shared by all passes of a picture. Internal to trace.

#include "scenefile/trace/film.h"
#include "scenefile/trace/tracer.h"

namespace scenefile {

RenderStatus render_pass(const Tracer& tracer, Film& film, const Progress& progress,
                         RenderStats* stats);

}  // namespace scenefile
