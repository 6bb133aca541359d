#pragma once
// Pictures in the window's OpenGL context. Needs that context current. Internal to the room.

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

  /// `version` tells pictures apart: nothing is done for the one that is there already.
  void show(const Texture& picture, std::uint64_t version);

  /// Takes over a part of the back buffer, in pixels from its lower left; the picture then stands
  /// on its head.
  void take(int x, int y, int width, int height);

  /// That of the picture that is there.
  std::uint64_t version() const { return version_; }

  /// The name of the texture; 0: no picture yet.
  unsigned name() const { return name_; }

 private:
  void bind();

  unsigned name_ = 0;
  std::uint64_t version_ = ~std::uint64_t{0};
};

/// Fills the bound framebuffer, of this size.
void clear_window(int width, int height, float red, float green, float blue);

/// What the window shows, before its buffers are swapped.
Texture read_window(int width, int height);

}  // namespace scenefile::viewer
