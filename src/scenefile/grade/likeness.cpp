#include "scenefile/grade/likeness.h"

#include <algorithm>

namespace scenefile {

namespace {

constexpr int tolerance = 2;

// How far a value lies outside of [low, high].
int outside(int value, int low, int high) {
  return std::max({0, low - tolerance - value, value - high - tolerance});
}

template <typename F>
Distance summed(const Texture& picture, const F& at) {
  Distance distance;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      int off = 0;
      for (int c = 0; c < 3; ++c) {
        off += at(x, y, c);
      }
      distance.sum += off;
      distance.pixels += off > 0 ? 1 : 0;
    }
  }
  return distance;
}

// Smallest or greatest values of 3x3 pixels, by rows and then by columns.
template <typename Choose>
Texture around(const Texture& picture, const Choose& choose) {
  Texture rows = picture;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::uint8_t* left = picture.texel(std::max(x - 1, 0), y);
      const std::uint8_t* right = picture.texel(std::min(x + 1, picture.width - 1), y);
      std::uint8_t* here = rows.rgb.data() + (picture.texel(x, y) - picture.rgb.data());
      for (int c = 0; c < 3; ++c) {
        here[c] = choose(choose(left[c], right[c]), here[c]);
      }
    }
  }
  Texture both = rows;
  const std::size_t row = std::size_t{3} * picture.width;
  for (int y = 0; y < picture.height; ++y) {
    const std::uint8_t* above = rows.texel(0, std::max(y - 1, 0));
    const std::uint8_t* below = rows.texel(0, std::min(y + 1, picture.height - 1));
    std::uint8_t* here = both.rgb.data() + row * y;
    for (std::size_t i = 0; i < row; ++i) {
      here[i] = choose(choose(above[i], below[i]), here[i]);
    }
  }
  return both;
}

}  // namespace

Distance strict_distance(const Texture& picture, const Texture& expected) {
  return summed(picture, [&](int x, int y, int c) {
    const int value = expected.texel(x, y)[c];
    return outside(picture.texel(x, y)[c], value, value);
  });
}

Distance tolerant_distance(const Texture& picture, const Texture& expected) {
  const Texture low =
      around(expected, [](std::uint8_t a, std::uint8_t b) { return std::min(a, b); });
  const Texture high =
      around(expected, [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
  return summed(picture, [&](int x, int y, int c) {
    return outside(picture.texel(x, y)[c], low.texel(x, y)[c], high.texel(x, y)[c]);
  });
}

Texture thinned(const Texture& picture, int step) {
  Texture result;
  result.width = (picture.width + step / 2) / step;
  result.height = (picture.height + step / 2) / step;
  result.rgb.reserve(std::size_t{3} * result.width * result.height);
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      const std::uint8_t* p = picture.texel(x * step + step / 2, y * step + step / 2);
      result.rgb.insert(result.rgb.end(), p, p + 3);
    }
  }
  return result;
}

}  // namespace scenefile
