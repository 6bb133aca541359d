#include "scenefile/compare/worst_region.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace scenefile {

namespace {

constexpr int blocks_across = 24;
constexpr int min_block = 4;  // pixels

int difference_at(const Texture& a, const Texture& b, int x, int y) {
  const std::uint8_t* p = a.texel(x, y);
  const std::uint8_t* q = b.texel(x, y);
  return std::max({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])});
}

// Square blocks of pixels with the sums of their differences.
struct Blocks {
  int size = 1;
  int columns = 0;
  int rows = 0;
  std::vector<double> sums;

  double& at(int column, int row) { return sums[static_cast<std::size_t>(row) * columns + column]; }
};

Blocks blocks_of(const Texture& a, const Texture& b, int threshold) {
  Blocks blocks;
  blocks.size = std::max(min_block, std::max(a.width, a.height) / blocks_across);
  blocks.columns = (a.width + blocks.size - 1) / blocks.size;
  blocks.rows = (a.height + blocks.size - 1) / blocks.size;
  blocks.sums.resize(static_cast<std::size_t>(blocks.columns) * blocks.rows);
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const int off = difference_at(a, b, x, y);
      blocks.at(x / blocks.size, y / blocks.size) += off > threshold ? off : 0;
    }
  }
  return blocks;
}

// The connected blocks around the worst one that are at least a third as bad.
std::vector<bool> around_the_worst(Blocks& blocks) {
  std::vector<bool> inside(blocks.sums.size());
  const auto worst = static_cast<std::size_t>(
      std::max_element(blocks.sums.begin(), blocks.sums.end()) - blocks.sums.begin());
  const double least = blocks.sums[worst] / 3;
  std::vector<std::size_t> open{worst};
  inside[worst] = true;
  while (!open.empty()) {
    const int column = static_cast<int>(open.back()) % blocks.columns;
    const int row = static_cast<int>(open.back()) / blocks.columns;
    open.pop_back();
    for (const auto& [dx, dy] :
         {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
      const int x = column + dx;
      const int y = row + dy;
      if (x < 0 || y < 0 || x >= blocks.columns || y >= blocks.rows) {
        continue;
      }
      const auto next = static_cast<std::size_t>(y) * blocks.columns + x;
      if (!inside[next] && blocks.sums[next] >= least) {
        inside[next] = true;
        open.push_back(next);
      }
    }
  }
  return inside;
}

}  // namespace

std::optional<WorstRegion> worst_region(const Texture& a, const Texture& b, int threshold) {
  if (a.width != b.width || a.height != b.height || a.empty()) {
    return std::nullopt;
  }
  Blocks blocks = blocks_of(a, b, threshold);
  const std::vector<bool> inside = around_the_worst(blocks);
  WorstRegion region{a.width, a.height, -1, -1, 0, 0, 0, 0};
  double all = 0;
  double here = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const int off = difference_at(a, b, x, y);
      if (off <= threshold) {
        continue;
      }
      all += off;
      if (inside[static_cast<std::size_t>(y / blocks.size) * blocks.columns + x / blocks.size]) {
        here += off;
        region.x0 = std::min(region.x0, x);
        region.y0 = std::min(region.y0, y);
        region.x1 = std::max(region.x1, x);
        region.y1 = std::max(region.y1, y);
      }
    }
  }
  if (region.x1 < 0) {
    return std::nullopt;
  }
  region.share = here / all;
  int best = -1;
  double sum = 0;
  for (int y = region.y0; y <= region.y1; ++y) {
    for (int x = region.x0; x <= region.x1; ++x) {
      sum += difference_at(a, b, x, y);
      // At an edge, a neighboring pixel has the right color, so the color there says little.
      int least = 255;
      for (int v = std::max(y - 2, 0); v <= std::min(y + 2, a.height - 1); ++v) {
        for (int u = std::max(x - 2, 0); u <= std::min(x + 2, a.width - 1); ++u) {
          least = std::min(least, difference_at(a, b, u, v));
        }
      }
      const int merit = 256 * least + difference_at(a, b, x, y);
      if (merit > best) {
        best = merit;
        region.x = x;
        region.y = y;
      }
    }
  }
  region.mean =
      sum / (static_cast<double>(region.x1 - region.x0 + 1) * (region.y1 - region.y0 + 1));
  return region;
}

}  // namespace scenefile
