#pragma once
// Pictures as plain data. Row 0 is the top row; pixels are stored row by row, as red, green, blue.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// A picture in floating point, 1 is full intensity. Renderers return it, encoders take it.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;  ///< 3 * width * height

  Image() = default;
  /// A black picture. Throws std::bad_alloc if there is not enough memory.
  Image(int w, int h);
  float* pixel(int x, int y) {
    return rgb.data() + (std::size_t{3} * width * y + 3 * std::size_t(x));
  }
  const float* pixel(int x, int y) const {
    return rgb.data() + (std::size_t{3} * width * y + 3 * std::size_t(x));
  }
};

/// A picture with 8-bit values, 255 is full intensity: textures, and the contents of 8-bit files.
/// 8 bits because scenes may use large textures. Gray is expanded, alpha dropped.
struct Texture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 * width * height
  std::string_view format = {};   ///< of its file, PictureFormat::name; empty if it has none

  bool empty() const { return rgb.empty(); }
  const std::uint8_t* texel(int x, int y) const {
    return rgb.data() + (std::size_t{3} * width * y + 3 * std::size_t(x));
  }
};

/// One layer of a picture: the colors, the normals, ...
struct ImageLayer {
  std::string name;                   ///< empty for the colors themselves
  std::vector<std::string> channels;  ///< names in the order of the values, such as R G B
  bool whole = false;                 ///< whole numbers from 0 to 2^24
  std::vector<float> values;  ///< channels * width * height, pixel by pixel, row 0 at the top
};

/// How a float becomes an integer: the course's programs truncate, others round.
enum class Rounding : std::uint8_t { truncate, nearest };

/// value * 255, clamped to [0, 255] (NaN counts as 0), truncated or rounded.
std::uint8_t quantize(float value, Rounding rounding);
/// The same for `count` values.
void quantize(const float* values, std::size_t count, Rounding rounding, std::uint8_t* to);
Texture quantize(const Image& image, Rounding rounding);
/// value / 255.
Image to_float(const Texture& texture);

}  // namespace scenefile
