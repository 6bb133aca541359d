#pragma once
// Pictures in the window's OpenGL context, which must be current. Internal to viewer.

#include "scenefile/asset/image.h"

#include <cstdint>

namespace scenefile::viewer {

/// A texture that shows one picture.
class GlPicture {
 public:
  GlPicture() = default;
  ~GlPicture();
  GlPicture(const GlPicture&) = delete;
  GlPicture& operator=(const GlPicture&) = delete;

  /// `version` identifies pictures: does nothing if that version is already shown.
  void show(const Texture& picture, std::uint64_t version);

  /// The version of the current picture.
  std::uint64_t version() const { return version_; }

  /// The texture's name; 0 before the first picture.
  unsigned name() const { return name_; }

 private:
  void bind();

  unsigned name_ = 0;
  std::uint64_t version_ = ~std::uint64_t{0};
};

/// Clears the bound framebuffer of this size.
void clear_window(int width, int height, float red, float green, float blue);

/// The contents of the window, before its buffers are swapped.
Texture read_window(int width, int height);

}  // namespace scenefile::viewer
