#include "scenefile/verbs/jpeg_noise.h"

#include "scenefile/trace/render.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace scenefile {

namespace {

std::vector<PixelRegion> blocks_of(const Texture& picture) {
  constexpr int side = 16;
  std::vector<PixelRegion> blocks;
  for (int top = 0; top < picture.height; top += side) {
    for (int left = 0; left < picture.width; left += side) {
      blocks.push_back(
          {left, top, std::min(left + side, picture.width), std::min(top + side, picture.height)});
    }
  }
  return blocks;
}

int contrast_in(const Texture& picture, const PixelRegion& block) {
  std::array<std::uint8_t, 3> low{255, 255, 255};
  std::array<std::uint8_t, 3> high{0, 0, 0};
  for (int y = block.y0; y < block.y1; ++y) {
    for (int x = block.x0; x < block.x1; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        low[c] = std::min(low[c], picture.texel(x, y)[c]);
        high[c] = std::max(high[c], picture.texel(x, y)[c]);
      }
    }
  }
  return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

}  // namespace

std::vector<float> contrast_of_blocks(const Texture& picture) {
  std::vector<float> contrast(std::size_t(picture.width) * std::size_t(picture.height));
  for (const PixelRegion& block : blocks_of(picture)) {
    const auto most = static_cast<float>(contrast_in(picture, block));
    for (int y = block.y0; y < block.y1; ++y) {
      const auto row = contrast.begin() + std::ptrdiff_t(y) * picture.width;
      std::fill(row + block.x0, row + block.x1, most);
    }
  }
  return contrast;
}

bool differ_by_compression(const Texture& reference, const Texture& test) {
  constexpr double max_share = 0.005;
  const auto largest = [](const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); };
  const std::vector<PixelRegion> blocks = blocks_of(test);
  std::size_t unlike = 0;
  for (const PixelRegion& block : blocks) {
    glm::dvec3 sum(0);
    glm::dvec3 squares(0);
    for (int y = block.y0; y < block.y1; ++y) {
      for (int x = block.x0; x < block.x1; ++x) {
        const std::uint8_t* r = reference.texel(x, y);
        const std::uint8_t* t = test.texel(x, y);
        const glm::dvec3 off(r[0] - t[0], r[1] - t[1], r[2] - t[2]);
        sum += off;
        squares += off * off;
      }
    }
    const double contrast = contrast_in(reference, block);
    const double pixels = block.width() * block.height();
    unlike += largest(glm::abs(sum)) / pixels > 3 + 0.02 * contrast ||
                      std::sqrt(largest(squares) / pixels) > 4 + 0.15 * contrast
                  ? 1
                  : 0;
  }
  return static_cast<double>(unlike) <= max_share * static_cast<double>(blocks.size());
}

}  // namespace scenefile
