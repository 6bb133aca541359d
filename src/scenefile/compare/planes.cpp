#include "scenefile/compare/planes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace scenefile {

namespace {

constexpr int side = 128;  // pixels of a tile: its planes fit in the cache

bool differs(const Texture& a, const Texture& b, const PlaneTile& tile) {
  const int left = std::max(tile.x - tile.reach, 0);
  const int right = std::min(tile.x + tile.width + tile.reach, a.width);
  const int bottom = std::min(tile.y + tile.height + tile.reach, a.height);
  for (int y = std::max(tile.y - tile.reach, 0); y < bottom; ++y) {
    if (std::memcmp(a.texel(left, y), b.texel(left, y), std::size_t{3} * (right - left)) != 0) {
      return true;
    }
  }
  return false;
}

// Filters a row of pixels that starts at `middle`; `step`: from a pixel to the next one along the
// filter. Differences to the middle keep precision, and make equal pixels times weights that sum to
// 0 exactly 0.
void filter_row(const Taps& taps, const float* middle, std::ptrdiff_t step, int width,
                float* __restrict to) {
  const auto total = static_cast<float>(sum_of(taps));
  for (int x = 0; x < width; ++x) {
    to[x] = total * middle[x];
  }
  const auto radius = static_cast<std::ptrdiff_t>(taps.size() / 2);
  for (std::ptrdiff_t i = 1; i <= radius; ++i) {
    const float* const before = middle - i * step;
    const float* const after = middle + i * step;
    const auto p = static_cast<float>(taps[radius - i]);
    const auto q = static_cast<float>(taps[radius + i]);
    for (int x = 0; x < width; ++x) {
      to[x] += p * (before[x] - middle[x]) + q * (after[x] - middle[x]);
    }
  }
}

}  // namespace

Taps gaussian_taps(int radius, double sigma) {
  Taps taps;
  for (int x = -radius; x <= radius; ++x) {
    taps.push_back(std::exp(-x * x / (2 * sigma * sigma)));
  }
  return taps;
}

double sum_of(const Taps& taps) {
  return std::accumulate(taps.begin(), taps.end(), 0.0);
}

Taps scaled_taps(Taps taps, double factor) {
  for (double& tap : taps) {
    tap *= factor;
  }
  return taps;
}

const std::uint8_t* PlaneTile::texel(const Texture& picture, int column, int row) const {
  return picture.texel(std::clamp(x + column - reach, 0, picture.width - 1),
                       std::clamp(y + row - reach, 0, picture.height - 1));
}

std::vector<PlaneTile> differing_tiles(const Texture& a, const Texture& b, int reach) {
  std::vector<PlaneTile> tiles;
  for (int y = 0; y < a.height; y += side) {
    for (int x = 0; x < a.width; x += side) {
      const PlaneTile tile{x, y, std::min(side, a.width - x), std::min(side, a.height - y), reach};
      if (differs(a, b, tile)) {
        tiles.push_back(tile);
      }
    }
  }
  return tiles;
}

Plane filtered(const Plane& plane, const PlaneTile& tile, const Taps& across, const Taps& down) {
  const int radius = static_cast<int>(down.size()) / 2;
  Plane rows(tile.width, tile.height + 2 * radius);
  for (int y = 0; y < rows.height; ++y) {
    filter_row(across, plane.row(y + tile.reach - radius) + tile.reach, 1, tile.width, rows.row(y));
  }
  Plane result(tile.width, tile.height);
  for (int y = 0; y < result.height; ++y) {
    filter_row(down, rows.row(y + radius), tile.width, tile.width, result.row(y));
  }
  return result;
}

}  // namespace scenefile
