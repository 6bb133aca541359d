#pragma once
// Offscreen framebuffers. Internal to view.

#include "scenefile/view/gl_objects.h"

namespace scenefile {

/// A render target: RGBA8, optionally with depth and multisampling.
struct PixelSurface {
  gl::Framebuffer framebuffer;
  gl::Renderbuffer color;
  gl::Texture texture;  ///< instead of `color`
  gl::Renderbuffer depth;
  int width = 0;
  int height = 0;
  int samples = 0;
};

/// Creates the surface again unless it already matches. Returns false if the device does not
/// support it.
bool fit(const gl::Functions& functions, PixelSurface& surface, int width, int height, int samples,
         bool with_depth);

/// Same with a texture, depth, and one sample per pixel. Shaders read it with linear interpolation.
bool fit_texture(const gl::Functions& functions, PixelSurface& surface, int width, int height);

}  // namespace scenefile
