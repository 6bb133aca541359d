#pragma once
// Framebuffers of the room's own. Internal to the room.

#include "scenefile/view/gl_objects.h"

namespace scenefile {

/// Something to draw on: RGBA8, perhaps with depth, perhaps with several samples a pixel.
struct PixelSurface {
  gl::Framebuffer framebuffer;
  gl::Renderbuffer color;
  gl::Texture texture;  ///< in place of `color`
  gl::Renderbuffer depth;
  int width = 0;
  int height = 0;
  int samples = 0;
};

/// Makes the surface anew where it is not of this kind; keeps it where it is. False where the
/// device cannot.
bool fit(const gl::Functions& functions, PixelSurface& surface, int width, int height, int samples,
         bool with_depth);

/// The same with a texture, one sample a pixel and depth. Shaders read it with linear
/// interpolation.
bool fit_texture(const gl::Functions& functions, PixelSurface& surface, int width, int height);

}  // namespace scenefile
