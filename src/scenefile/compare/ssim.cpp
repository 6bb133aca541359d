#include "scenefile/compare/ssim.h"

#include "scenefile/compare/planes.h"

#include <algorithm>

namespace scenefile {

namespace {

constexpr int radius = 5;
constexpr float c1 = (0.01F * 255) * (0.01F * 255);
constexpr float c2 = (0.03F * 255) * (0.03F * 255);
// Values are centered on 0, so that squares keep enough precision in floats.
constexpr float middle = 128;

float luma(int red, int green, int blue) {
  return 0.299F * static_cast<float>(red) + 0.587F * static_cast<float>(green) +
         0.114F * static_cast<float>(blue);
}

// 1 - SSIM of each pixel of the tile. From the means of s = (a + b) / 2 - middle, d = a - b and
// their squares instead of those of a and b, so that similar pictures lose no precision.
Plane dissimilarities(const Texture& first, const Texture& second, const PlaneTile& tile,
                      const Taps& taps) {
  Plane s = tile.with_surroundings();
  Plane d = s;
  for (int y = 0; y < s.height; ++y) {
    for (int x = 0; x < s.width; ++x) {
      const std::uint8_t* const a = tile.texel(first, x, y);
      const std::uint8_t* const b = tile.texel(second, x, y);
      s.row(y)[x] = luma(a[0] + b[0], a[1] + b[1], a[2] + b[2]) / 2 - middle;
      d.row(y)[x] = luma(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
  }
  const auto mean = [&](const Plane& plane) { return filtered(plane, tile, taps, taps); };
  const auto mean_square = [&](Plane plane) {
    for (float& value : plane.values) {
      value *= value;
    }
    return mean(plane);
  };
  Plane result = mean(s);
  const Plane mean_d = mean(d);
  const Plane ss = mean_square(std::move(s));
  const Plane dd = mean_square(std::move(d));
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    const float s_2 = result.values[i] * result.values[i];
    const float d_2 = mean_d.values[i] * mean_d.values[i];
    const float full = result.values[i] + middle;
    // Of a and b, 2 E[a] E[b] and E[a]^2 + E[b]^2 are 2 full^2 -+ d^2 / 2; likewise of
    // (co)variances.
    const float light = d_2 / (2 * full * full + d_2 / 2 + c1);
    const float spread = dd.values[i] - d_2;
    const float structure = spread / (2 * (ss.values[i] - s_2) + spread / 2 + c2);
    result.values[i] = light + structure - light * structure;
  }
  return result;
}

}  // namespace

double ssim(const Texture& a, const Texture& b) {
  if (a.width != b.width || a.height != b.height || a.empty()) {
    return a.empty() && b.empty() ? 1 : 0;
  }
  Taps taps = gaussian_taps(radius, 1.5);
  taps = scaled_taps(taps, 1 / sum_of(taps));
  const int left = a.width > 2 * radius ? radius : 0;
  const int top = a.height > 2 * radius ? radius : 0;
  double sum = 0;  // of 1 - SSIM; where the pictures are equal, it is 0
  for (const PlaneTile& tile : differing_tiles(a, b, radius)) {
    const Plane errors = dissimilarities(a, b, tile, taps);
    for (int y = std::max(tile.y, top); y < std::min(tile.y + tile.height, a.height - top); ++y) {
      const float* const row = errors.row(y - tile.y) - tile.x;
      for (int x = std::max(tile.x, left); x < std::min(tile.x + tile.width, a.width - left); ++x) {
        sum += row[x];
      }
    }
  }
  return 1 - sum / (static_cast<double>(a.width - 2 * left) * (a.height - 2 * top));
}

}  // namespace scenefile
