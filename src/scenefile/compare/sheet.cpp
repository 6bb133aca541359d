#include "scenefile/compare/sheet.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace scenefile {

namespace {

constexpr std::uint8_t gray = 96;

Texture blank(int width, int height, std::uint8_t value) {
  Texture result;
  result.width = width;
  result.height = height;
  result.rgb.assign(std::size_t{3} * width * height, value);
  return result;
}

std::uint8_t* texel(Texture& picture, int x, int y) {
  return picture.rgb.data() + std::size_t{3} * (std::size_t(y) * picture.width + x);
}

bool holds(const Texture& picture, int x, int y) {
  return x < picture.width && y < picture.height;
}

int worst_channel(const std::uint8_t* a, const std::uint8_t* b) {
  int worst = 0;
  for (int c = 0; c < 3; ++c) {
    worst = std::max(worst, std::abs(int{a[c]} - int{b[c]}));
  }
  return worst;
}

}  // namespace

void magma(double value, std::uint8_t* rgb) {
  // A polynomial fit of degree 6 to the published table, accurate to 2/255.
  static const std::array<glm::dvec3, 7> fit{
      {{-0.002136485053939582, -0.000749655052795221, -0.005386127855323933},
       {0.2516605407371642, 0.6775232436837668, 2.494026599312351},
       {8.353717279216625, -3.577719514958484, 0.3144679030132573},
       {-27.66873308576866, 14.26473078096533, -13.64921318813922},
       {52.17613981234068, -27.94360607168351, 12.94416944238394},
       {-50.76852536473588, 29.04658282127291, 4.23415299384598},
       {18.65570506591883, -11.48977351997711, -5.601961508734096}}};
  const double t = std::clamp(value, 0.0, 1.0);
  glm::dvec3 color(0);
  for (auto term = fit.rbegin(); term != fit.rend(); ++term) {
    color = color * t + *term;
  }
  for (int c = 0; c < 3; ++c) {
    rgb[c] = quantize(static_cast<float>(color[c]), Rounding::nearest);
  }
}

Texture heat_map(const Texture& a, const Texture& b) {
  Texture result = blank(std::max(a.width, b.width), std::max(a.height, b.height), 0);
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      const bool both = holds(a, x, y) && holds(b, x, y);
      const int worst = both ? worst_channel(a.texel(x, y), b.texel(x, y)) : 255;
      magma(std::sqrt(worst / 255.0), texel(result, x, y));
    }
  }
  return result;
}

Texture flip_picture(const std::vector<float>& errors, int width, int height) {
  Texture result;
  if (errors.size() == std::size_t(width) * height) {
    result = blank(width, height, 0);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      magma(errors[i], result.rgb.data() + 3 * i);
    }
  }
  return result;
}

Texture reduced(const Texture& picture, int width) {
  if (picture.width <= width) {
    return picture;
  }
  const auto bound = [](int index, int size, int old_size) {
    return static_cast<int>(std::int64_t{index} * old_size / size);
  };
  const int height = std::max(1, bound(picture.height, picture.width, width));
  Texture result = blank(width, height, 0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      glm::ivec3 sum(0);
      int count = 0;
      const int bottom =
          std::max(bound(y + 1, height, picture.height), bound(y, height, picture.height) + 1);
      for (int j = bound(y, height, picture.height); j < bottom; ++j) {
        for (int i = bound(x, width, picture.width); i < bound(x + 1, width, picture.width); ++i) {
          const std::uint8_t* p = picture.texel(i, j);
          sum += glm::ivec3(p[0], p[1], p[2]);
          ++count;
        }
      }
      for (int c = 0; c < 3; ++c) {
        texel(result, x, y)[c] = static_cast<std::uint8_t>((sum[c] + count / 2) / count);
      }
    }
  }
  return result;
}

Texture scaled(const Texture& picture, int width, int height) {
  Texture result;
  if (picture.empty() || width <= 0 || height <= 0) {
    return result;
  }
  result.width = width;
  result.height = height;
  result.rgb.resize(std::size_t{3} * width * height);
  const double across = static_cast<double>(picture.width) / width;
  const double down = static_cast<double>(picture.height) / height;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double left = x * across;
      const double right = left + across;
      const double top = y * down;
      const double bottom = top + down;
      std::array<double, 3> sum{};
      double area = 0;
      for (int v = static_cast<int>(top); v < std::min<double>(bottom, picture.height); ++v) {
        for (int u = static_cast<int>(left); u < std::min<double>(right, picture.width); ++u) {
          const double share = (std::min<double>(right, u + 1) - std::max<double>(left, u)) *
                               (std::min<double>(bottom, v + 1) - std::max<double>(top, v));
          for (std::size_t i = 0; i < 3; ++i) {
            sum[i] += share * picture.texel(u, v)[i];
          }
          area += share;
        }
      }
      for (std::size_t i = 0; i < 3; ++i) {
        result.rgb[3 * (static_cast<std::size_t>(y) * width + x) + i] =
            static_cast<std::uint8_t>(std::lround(sum[i] / std::max(area, 1e-12)));
      }
    }
  }
  return result;
}

Texture side_by_side(std::span<const Texture* const> pictures, int gap) {
  int width = 0;
  int height = 0;
  for (const Texture* picture : pictures) {
    width = std::max(width, picture->width);
    height = std::max(height, picture->height);
  }
  const int columns = static_cast<int>(pictures.size());
  Texture sheet = blank(columns * (width + gap) + gap, height + 2 * gap, gray);
  int left = gap;
  for (const Texture* picture : pictures) {
    for (int y = 0; y < picture->height; ++y) {
      const std::uint8_t* row = picture->texel(0, y);
      std::copy(row, row + std::size_t{3} * picture->width, texel(sheet, left, gap + y));
    }
    left += width + gap;
  }
  return sheet;
}

}  // namespace scenefile
