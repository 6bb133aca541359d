#include "scenefile/trace/texture_lookup.h"

#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/geometry/surface-inl.h"
#include "scenefile/trace/camera-inl.h"
#include "scenefile/trace/footprint-inl.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

int wrap(double index, int size) {
  const double wrapped = index - size * std::floor(index / size);
  return std::clamp(static_cast<int>(wrapped), 0, size - 1);
}

glm::dvec3 texel(const Texture& texture, int x, int y) {
  const std::uint8_t* p = texture.texel(x, y);
  return glm::dvec3(p[0], p[1], p[2]) / 255.0;
}

// Texel coordinates, x to the right and y down.
glm::dvec2 texel_position(const Texture& texture, const RenderTexture& use, const glm::dvec2& uv) {
  return {one::texel_x(uv.x, use.repeat_u, texture.width),
          one::texel_y(uv.y, use.repeat_v, texture.height)};
}

// How much a new texel covers of each old one along an axis.
struct Cover {
  int first = 0;
  double weights[3] = {0, 0, 0};
};

Cover cover(int index, int new_size, int old_size) {
  const double scale = double(old_size) / new_size;
  const double begin = index * scale;
  const double end = begin + scale;
  Cover result;
  result.first = std::min(static_cast<int>(begin), old_size - 1);
  for (int i = 0; i < 3; ++i) {
    const double low = std::max<double>(begin, result.first + i);
    const double high = std::min<double>(end, result.first + i + 1);
    result.weights[i] = std::max(0.0, high - low) / scale;
  }
  return result;
}

Texture halved(const Texture& texture) {
  Texture result;
  result.width = std::max(1, texture.width / 2);
  result.height = std::max(1, texture.height / 2);
  result.rgb.resize(std::size_t{3} * result.width * result.height);
  for (int y = 0; y < result.height; ++y) {
    const Cover rows = cover(y, result.height, texture.height);
    for (int x = 0; x < result.width; ++x) {
      const Cover columns = cover(x, result.width, texture.width);
      glm::dvec3 sum(0);
      for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) {
          const double weight = rows.weights[j] * columns.weights[i];
          if (weight > 0) {
            const std::uint8_t* p = texture.texel(columns.first + i, rows.first + j);
            sum += weight * glm::dvec3(p[0], p[1], p[2]);
          }
        }
      }
      for (int c = 0; c < 3; ++c) {
        result.rgb[std::size_t{3} * (std::size_t(y) * result.width + x) + c] =
            static_cast<std::uint8_t>(std::clamp(sum[c] + 0.5, 0.0, 255.0));
      }
    }
  }
  return result;
}

}  // namespace

glm::ivec2 texel_at(const Texture& texture, const RenderTexture& use, const glm::dvec2& uv) {
  const glm::dvec2 p = glm::floor(texel_position(texture, use, uv));
  return {wrap(p.x, texture.width), wrap(p.y, texture.height)};
}

glm::dvec3 lookup_nearest(const Texture& texture, const RenderTexture& use, const glm::dvec2& uv) {
  const glm::ivec2 p = texel_at(texture, use, uv);
  return texel(texture, p.x, p.y);
}

glm::dvec3 lookup_smooth(const Texture& texture, const RenderTexture& use, const glm::dvec2& uv) {
  const glm::dvec2 p = texel_position(texture, use, uv) - 0.5;
  const one::V3 color =
      one::bilinear(texture.width, texture.height, p.x, p.y, [&](double x, double y) {
        return one::splat3(texel(texture, static_cast<int>(x), static_cast<int>(y)));
      });
  return {color.x, color.y, color.z};
}

MipMap::MipMap(const Texture& texture) : base_(&texture) {
  const Texture* last = base_;
  while (last->width > 1 || last->height > 1) {
    smaller_.push_back(halved(*last));
    last = &smaller_.back();
  }
}

}  // namespace scenefile
