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
  return {uv.x * use.repeat_u * texture.width, (1 - uv.y) * use.repeat_v * texture.height};
}

// Interpolates the four texels around p; texel centers are at integer positions.
glm::dvec3 bilinear(const Texture& texture, const glm::dvec2& p) {
  const glm::dvec2 low = glm::floor(p);
  const glm::dvec2 f = p - low;
  const int x0 = wrap(low.x, texture.width);
  const int y0 = wrap(low.y, texture.height);
  const int x1 = x0 + 1 == texture.width ? 0 : x0 + 1;
  const int y1 = y0 + 1 == texture.height ? 0 : y0 + 1;
  const glm::dvec3 top = glm::mix(texel(texture, x0, y0), texel(texture, x1, y0), f.x);
  const glm::dvec3 bottom = glm::mix(texel(texture, x0, y1), texel(texture, x1, y1), f.x);
  return glm::mix(top, bottom, f.y);
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

// A texture with the interface for filtered(), for one lane.
struct OneTexture {
  const MipMap& mip_map;

  double levels() const { return mip_map.levels(); }

  one::V3 smooth(double level, bool wanted, double x, double y) const {
    if (!wanted) {
      return {0, 0, 0};
    }
    const Texture& base = mip_map.level(0);
    const Texture& texture = mip_map.level(static_cast<int>(level));
    return one::bilinear(
        texture.width, texture.height, x * (double(texture.width) / base.width) - 0.5,
        y * (double(texture.height) / base.height) - 0.5, [&](double column, double row) {
          return one::splat3(texel(texture, static_cast<int>(column), static_cast<int>(row)));
        });
  }
};

}  // namespace

glm::ivec2 texel_at(const Texture& texture, const RenderTexture& use, const glm::dvec2& uv) {
  const glm::dvec2 p = glm::floor(texel_position(texture, use, uv));
  return {wrap(p.x, texture.width), wrap(p.y, texture.height)};
}

glm::dvec3 lookup_nearest(const Texture& texture, const RenderTexture& use, const glm::dvec2& uv) {
  const glm::ivec2 p = texel_at(texture, use, uv);
  return texel(texture, p.x, p.y);
}

glm::dvec3 lookup_course_filter(const Texture& texture, const RenderTexture& use,
                                const glm::dvec2& uv) {
  return bilinear(texture, texel_position(texture, use, uv));
}

MipMap::MipMap(const Texture& texture) : base_(&texture) {
  const Texture* last = base_;
  while (last->width > 1 || last->height > 1) {
    smaller_.push_back(halved(*last));
    last = &smaller_.back();
  }
}

glm::dvec3 lookup_filtered(const MipMap& mip_map, const RenderTexture& use, const glm::dvec2& uv,
                           const UvFootprint& footprint, int grid) {
  const Texture& base = mip_map.level(0);
  const one::V3 color =
      one::filtered(OneTexture{mip_map}, one::texel_x(uv.x, use.repeat_u, base.width),
                    one::texel_y(uv.y, use.repeat_v, base.height),
                    one::texel_footprint({footprint.right.x, footprint.right.y},
                                         {footprint.down.x, footprint.down.y}, use.repeat_u,
                                         use.repeat_v, base.width, base.height),
                    grid, true);
  return {color.x, color.y, color.z};
}

}  // namespace scenefile
