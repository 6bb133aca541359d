#include "scenefile/view/targets.h"

namespace scenefile {

namespace {

gl::Renderbuffer storage(const gl::Functions& gl, gl::Enum attachment, gl::Enum format, int width,
                         int height, int samples) {
  gl::Renderbuffer buffer(gl);
  gl.BindRenderbuffer(gl::RENDERBUFFER, buffer.name());
  gl.RenderbufferStorageMultisample(gl::RENDERBUFFER, samples > 1 ? samples : 0, format, width,
                                    height);
  gl.FramebufferRenderbuffer(gl::FRAMEBUFFER, attachment, gl::RENDERBUFFER, buffer.name());
  return buffer;
}

}  // namespace

bool fit(const gl::Functions& gl, PixelSurface& surface, int width, int height, int samples,
         bool with_depth) {
  if (surface.framebuffer && surface.width == width && surface.height == height &&
      surface.samples == samples) {
    return true;
  }
  surface = PixelSurface();
  surface.framebuffer = gl::Framebuffer(gl);
  gl.BindFramebuffer(gl::FRAMEBUFFER, surface.framebuffer.name());
  surface.color = storage(gl, gl::COLOR_ATTACHMENT0, gl::RGBA8, width, height, samples);
  if (with_depth) {
    surface.depth =
        storage(gl, gl::DEPTH_ATTACHMENT, gl::DEPTH_COMPONENT24, width, height, samples);
  }
  surface.width = width;
  surface.height = height;
  surface.samples = samples;
  const bool complete = gl.CheckFramebufferStatus(gl::FRAMEBUFFER) == gl::FRAMEBUFFER_COMPLETE;
  if (!complete) {
    surface = PixelSurface();
  }
  return complete;
}

bool fit_texture(const gl::Functions& gl, PixelSurface& surface, int width, int height) {
  if (surface.framebuffer && surface.width == width && surface.height == height) {
    return true;
  }
  surface = PixelSurface();
  surface.framebuffer = gl::Framebuffer(gl);
  gl.BindFramebuffer(gl::FRAMEBUFFER, surface.framebuffer.name());
  surface.texture = gl::Texture(gl);
  gl.BindTexture(gl::TEXTURE_2D, surface.texture.name());
  gl.TexImage2D(gl::TEXTURE_2D, 0, gl::RGBA8, width, height, 0, gl::RGBA, gl::UNSIGNED_BYTE,
                nullptr);
  gl.TexParameteri(gl::TEXTURE_2D, gl::TEXTURE_MIN_FILTER, gl::LINEAR);
  gl.TexParameteri(gl::TEXTURE_2D, gl::TEXTURE_MAG_FILTER, gl::LINEAR);
  gl.FramebufferTexture2D(gl::FRAMEBUFFER, gl::COLOR_ATTACHMENT0, gl::TEXTURE_2D,
                          surface.texture.name(), 0);
  surface.depth = storage(gl, gl::DEPTH_ATTACHMENT, gl::DEPTH_COMPONENT24, width, height, 1);
  surface.width = width;
  surface.height = height;
  surface.samples = 1;
  const bool complete = gl.CheckFramebufferStatus(gl::FRAMEBUFFER) == gl::FRAMEBUFFER_COMPLETE;
  if (!complete) {
    surface = PixelSurface();
  }
  return complete;
}

}  // namespace scenefile
