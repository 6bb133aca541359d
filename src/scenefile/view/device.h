#pragma once
// The state of a device. Internal to view.

#include "scenefile/view/programs.h"
#include "scenefile/view/targets.h"

#include <functional>
#include <string>

namespace scenefile {

struct GlDevice::State {
  gl::Functions gl;
  std::string renderer;
  int max_side = 0;             ///< maximum side of a framebuffer, pixels
  int max_samples = 1;          ///< maximum per pixel
  std::function<bool()> go_on;  ///< of interrupt_with()
  bool interrupted = false;     ///< `go_on` has ended the current drawing
  Programs programs{gl};
  PixelSurface multisampled;
  PixelSurface resolved;
  PixelSurface quartered;  ///< intermediate: 4 x 4 of its pixels make one of the picture
  PixelSurface halved;
  PixelSurface picking;
  PixelSurface framed;          ///< the input of a realtime filter
  gl::VertexArray no_vertices;  ///< for shaders that generate their vertices
};

}  // namespace scenefile
