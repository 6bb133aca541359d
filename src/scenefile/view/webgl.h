#pragma once
// WebGL2 for the room, compiled to WebAssembly.

#include "scenefile/view/draw.h"

namespace scenefile {

/// For GlDevice::create(). Emscripten's current context must be a WebGL2 context.
GlFunction find_webgl_function(const char* name);

}  // namespace scenefile
