#pragma once
// Pictures in the window's OpenGL context, which must be current. Internal to viewer.

#include "scenefile/asset/image.h"

#include <cstddef>
#include <cstdint>

namespace scenefile::viewer {

/// A texture that shows one picture.
class GlPicture {
 public:
  GlPicture() = default;
  ~GlPicture();
  GlPicture(const GlPicture&) = delete;
  GlPicture& operator=(const GlPicture&) = delete;

  /// `version` identifies pictures: does nothing if that version is already shown. Uploads about
  /// `texels` at most: a larger picture is shown after several calls. Returns whether it is shown.
  bool show(const Texture& picture, std::uint64_t version, std::size_t texels = ~std::size_t{0});

  /// The texture's name; 0 before the first picture.
  unsigned name() const { return name_; }

 private:
  static constexpr std::uint64_t none = ~std::uint64_t{0};

  unsigned name_ = 0;
  std::uint64_t version_ = none;
  unsigned next_name_ = 0;  // of the texture that is being filled
  std::uint64_t next_version_ = none;
  int next_row_ = 0;
};

/// Clears the bound framebuffer of this size.
void clear_window(int width, int height, float red, float green, float blue);

/// The contents of the window, before its buffers are swapped.
Texture read_window(int width, int height);

}  // namespace scenefile::viewer
