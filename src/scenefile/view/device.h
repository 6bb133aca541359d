#pragma once
// What a device keeps. Internal to the room.

#include "scenefile/view/programs.h"
#include "scenefile/view/targets.h"

#include <string>

namespace scenefile {

struct GlDevice::State {
  gl::Functions gl;
  std::string renderer;
  int max_side = 0;     ///< of a framebuffer, pixels
  int max_samples = 1;  ///< of a pixel
  Programs programs{gl};
  PixelSurface multisampled;
  PixelSurface resolved;
  PixelSurface quartered;  ///< 16 of its pixels are one of the picture, on their way
  PixelSurface halved;
  PixelSurface picking;
  PixelSurface framed;          ///< what a realtime filter reads
  gl::VertexArray no_vertices;  ///< for shaders that make their own
};

}  // namespace scenefile
