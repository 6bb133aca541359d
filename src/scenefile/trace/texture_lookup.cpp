#include "scenefile/trace/texture_lookup.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

// More samples than this along a long footprint cost more than they show.
constexpr int max_taps = 16;

int wrap(double index, int size) {
  const double wrapped = index - size * std::floor(index / size);
  return std::clamp(static_cast<int>(wrapped), 0, size - 1);
}

glm::dvec3 texel(const Texture& texture, int x, int y) {
  const std::uint8_t* p = texture.texel(x, y);
  return glm::dvec3(p[0], p[1], p[2]) / 255.0;
}

// Texel coordinates, x right and y down.
glm::dvec2 texel_position(const Texture& texture, const RenderTexture& use, const glm::dvec2& uv) {
  return {uv.x * use.repeat_u * texture.width, (1 - uv.y) * use.repeat_v * texture.height};
}

// Between the four texels around p, where whole numbers are the places of texels.
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

// How much of each old texel a new one covers along one axis.
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

glm::dvec3 smooth_at(const Pyramid& pyramid, int level, const glm::dvec2& base_position) {
  const Texture& base = pyramid.level(0);
  const Texture& texture = pyramid.level(level);
  const glm::dvec2 scale(double(texture.width) / base.width, double(texture.height) / base.height);
  return bilinear(texture, base_position * scale - 0.5);
}

glm::dvec3 between_levels(const Pyramid& pyramid, double level, const glm::dvec2& base_position) {
  const double last = pyramid.levels() - 1;
  const double clamped = std::clamp(level, 0.0, last);
  const int low = static_cast<int>(clamped);
  const double f = clamped - low;
  const glm::dvec3 color = smooth_at(pyramid, low, base_position);
  return f > 0 ? glm::mix(color, smooth_at(pyramid, low + 1, base_position), f) : color;
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

glm::dvec3 lookup_course_filter(const Texture& texture, const RenderTexture& use,
                                const glm::dvec2& uv) {
  return bilinear(texture, texel_position(texture, use, uv));
}

Pyramid::Pyramid(const Texture& texture) : base_(&texture) {
  const Texture* last = base_;
  while (last->width > 1 || last->height > 1) {
    smaller_.push_back(halved(*last));
    last = &smaller_.back();
  }
}

glm::dvec3 lookup_filtered(const Pyramid& pyramid, const RenderTexture& use, const glm::dvec2& uv,
                           const UvFootprint& footprint) {
  const Texture& base = pyramid.level(0);
  const glm::dvec2 scale(double(use.repeat_u) * base.width, -double(use.repeat_v) * base.height);
  glm::dvec2 major = footprint.major * scale;
  double longer = glm::length(major);
  double shorter = glm::length(footprint.minor * scale);
  if (shorter > longer) {
    std::swap(longer, shorter);
    major = footprint.minor * scale;
  }
  const double level_width = std::max({shorter, longer / max_taps, 1.0});
  const double level = std::isfinite(level_width) ? std::log2(level_width) : pyramid.levels();
  const double ratio = std::isfinite(longer) ? std::ceil(longer / level_width) : 1.0;
  const int taps = static_cast<int>(std::clamp(ratio, 1.0, double(max_taps)));
  const glm::dvec2 center = texel_position(base, use, uv);
  glm::dvec3 sum(0);
  for (int i = 0; i < taps; ++i) {
    const double along = (i + 0.5) / taps - 0.5;
    sum += between_levels(pyramid, level, taps == 1 ? center : center + along * major);
  }
  return sum / double(taps);
}

}  // namespace scenefile
