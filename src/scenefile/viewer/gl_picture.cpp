#include "scenefile/viewer/gl_picture.h"

// OpenGL 1.1, which every system's library exports; the room view draws the scene itself.
#include <GL/gl.h>

#include <algorithm>
#include <cstddef>

namespace scenefile::viewer {

namespace {

constexpr GLint clamp_to_edge = 0x812F;  // OpenGL 1.2

}  // namespace

GlPicture::~GlPicture() {
  if (name_ != 0) {
    glDeleteTextures(1, &name_);
  }
}

void GlPicture::bind() {
  if (name_ == 0) {
    glGenTextures(1, &name_);
  }
  glBindTexture(GL_TEXTURE_2D, name_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, clamp_to_edge);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, clamp_to_edge);
}

void GlPicture::show(const Texture& picture, std::uint64_t version) {
  if (version == version_ || picture.empty()) {
    return;
  }
  version_ = version;
  bind();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, picture.width, picture.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
               picture.rgb.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void clear_window(int width, int height, float red, float green, float blue) {
  glViewport(0, 0, width, height);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(red, green, blue, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

Texture read_window(int width, int height) {
  Texture picture;
  picture.width = width;
  picture.height = height;
  const std::size_t row = std::size_t{3} * width;
  picture.rgb.resize(row * height);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadBuffer(GL_BACK);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, picture.rgb.data());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  // OpenGL's first row is at the bottom.
  for (int y = 0; y < height / 2; ++y) {
    std::swap_ranges(picture.rgb.begin() + row * y, picture.rgb.begin() + row * (y + 1),
                     picture.rgb.end() - row * (y + 1));
  }
  return picture;
}

}  // namespace scenefile::viewer
