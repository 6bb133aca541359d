#pragma once
// Converts RenderOptions (trace/render_options.h) to OpenGL. Used by both `--engine gl` and the
// window, so that they agree.

#include "scenefile/trace/render_options.h"
#include "scenefile/view/draw.h"

namespace scenefile {

/// The drawing options. `samples` is OpenGL's default unless the user gave a number, because the
/// tracer's default would not make sense.
DrawOptions draw_options(const RenderOptions& options);

/// The upload options that go with draw_options() of the same options.
UploadOptions upload_options(const RenderOptions& options);

}  // namespace scenefile
