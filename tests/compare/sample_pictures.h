#pragma once
// Pictures defined by formulas, so that other programs can create the same.

#include "scenefile/asset/image.h"

#include <algorithm>
#include <initializer_list>

namespace scenefile::compare_test {

inline Texture blank(int width, int height, std::initializer_list<int> color = {0, 0, 0}) {
  Texture t;
  t.width = width;
  t.height = height;
  t.rgb.resize(std::size_t{3} * width * height);
  for (std::size_t i = 0; i < t.rgb.size(); ++i) {
    t.rgb[i] = static_cast<std::uint8_t>(color.begin()[i % 3]);
  }
  return t;
}

/// Repeating ramps, and rings.
inline Texture pattern(int width, int height, int seed) {
  Texture t = blank(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      std::uint8_t* p = t.rgb.data() + 3 * (y * width + x);
      p[0] = static_cast<std::uint8_t>((x * 5 + seed * 17) % 256);
      p[1] = static_cast<std::uint8_t>((y * 7 + seed * 29) % 256);
      p[2] = static_cast<std::uint8_t>(((x * x + y * y * 3 + seed * 31) / 8) % 256);
    }
  }
  return t;
}

inline Texture mirrored(const Texture& t) {
  Texture result = t;
  for (int y = 0; y < t.height; ++y) {
    for (int x = 0; x < t.width; ++x) {
      std::copy_n(t.texel(t.width - 1 - x, y), 3, result.rgb.data() + 3 * (y * t.width + x));
    }
  }
  return result;
}

inline Texture darkened(const Texture& t, int by) {
  Texture result = t;
  for (std::uint8_t& value : result.rgb) {
    value = static_cast<std::uint8_t>(std::max(0, value - by));
  }
  return result;
}

}  // namespace scenefile::compare_test
