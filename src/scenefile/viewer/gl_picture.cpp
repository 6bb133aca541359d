#include "scenefile/viewer/gl_picture.h"

// OpenGL 1.1, which every system's library exports; the room view draws the scene itself.
#include <GL/gl.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace scenefile::viewer {

namespace {

constexpr GLint clamp_to_edge = 0x812F;  // OpenGL 1.2

}  // namespace

GlPicture::~GlPicture() {
  glDeleteTextures(1, &name_);  // OpenGL ignores 0
  glDeleteTextures(1, &next_name_);
}

bool GlPicture::show(const Texture& picture, std::uint64_t version, std::size_t texels) {
  if (version == version_ || picture.empty()) {
    return true;
  }
  if (next_name_ == 0) {
    glGenTextures(1, &next_name_);
    next_version_ = none;
  }
  glBindTexture(GL_TEXTURE_2D, next_name_);
  if (version != next_version_) {
    next_version_ = version;
    next_row_ = 0;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, clamp_to_edge);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, clamp_to_edge);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, picture.width, picture.height, 0, GL_RGB,
                 GL_UNSIGNED_BYTE, nullptr);
    if (texels < picture.rgb.size() / 3) {
      return false;
    }
  }
  const std::size_t rows = std::max<std::size_t>(1, texels / std::size_t(picture.width));
  const int count = int(std::min(rows, std::size_t(picture.height - next_row_)));
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, next_row_, picture.width, count, GL_RGB, GL_UNSIGNED_BYTE,
                  picture.texel(0, next_row_));
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  next_row_ += count;
  if (next_row_ == picture.height) {
    std::swap(name_, next_name_);
    version_ = version;
    next_version_ = none;
    glDeleteTextures(1, &next_name_);
    next_name_ = 0;
  }
  return version_ == version;
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
