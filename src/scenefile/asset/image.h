#pragma once
// Pictures as plain data. Row 0 is the top row; pixels lie row after row, red green blue.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace scenefile {

/// A picture in floating point, 1 is full. What renderers return and writers take.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;  ///< 3 * width * height

  Image() = default;
  /// Black. std::bad_alloc where there is no room for it.
  Image(int w, int h);
  float* pixel(int x, int y) {
    return rgb.data() + (std::size_t{3} * width * y + 3 * std::size_t(x));
  }
  const float* pixel(int x, int y) const {
    return rgb.data() + (std::size_t{3} * width * y + 3 * std::size_t(x));
  }
};

/// A picture in 8-bit, 255 is full: textures, and what 8-bit files hold. Kept small because scenes
/// may name large ones. Gray is expanded, alpha dropped.
struct Texture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 * width * height

  bool empty() const { return rgb.empty(); }
  const std::uint8_t* texel(int x, int y) const {
    return rgb.data() + (std::size_t{3} * width * y + 3 * std::size_t(x));
  }
};

/// Part of a picture that has several: its own, its normals, ...
struct ImageLayer {
  std::string name;                   ///< empty: the picture itself
  std::vector<std::string> channels;  ///< names in the order of the values, such as R G B
  bool whole = false;                 ///< whole numbers from 0 to 2^24
  std::vector<float> values;  ///< channels * width * height, pixel after pixel, row 0 on top
};

/// How a float becomes an integer: the course's programs truncate, good ones round.
enum class Rounding : std::uint8_t { truncate, nearest };

/// value * 255, clamped to [0, 255] (not a number counts as 0), truncated or rounded.
std::uint8_t quantize(float value, Rounding rounding);
/// `count` of them.
void quantize(const float* values, std::size_t count, Rounding rounding, std::uint8_t* to);
Texture quantize(const Image& image, Rounding rounding);
/// value / 255.
Image to_float(const Texture& texture);

}  // namespace scenefile
