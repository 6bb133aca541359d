#pragma once
// A picture that is asked for (trace/render_options.h) in the terms of OpenGL. The program's
// `--engine gl` and the window both ask here, so that they cannot differ.

#include "scenefile/trace/render_options.h"
#include "scenefile/view/draw.h"

namespace scenefile {

/// What to draw. `samples` is what OpenGL takes of itself, as it has no use for the tracer's number
/// unless a user gave it.
DrawOptions draw_options(const RenderOptions& options);

/// How the scene is to be put on the card for draw_options() of the same options.
UploadOptions upload_options(const RenderOptions& options);

}  // namespace scenefile
