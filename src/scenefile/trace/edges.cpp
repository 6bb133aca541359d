#include "scenefile/trace/edges.h"

#include "scenefile/trace/tiles.h"

#include <algorithm>
#include <vector>

namespace scenefile {

namespace {

constexpr float third = 1.0f / 3;

// How much squared differences within one surface count for edges.
constexpr float on_one_surface = 1.0f / 128;

float clamped(float value) {
  return std::clamp(value, 0.0f, 1.0f);
}

// The channels of a row in separate arrays, padded with a copy of the first and the last pixel.
struct Row {
  std::vector<float> channel[3];
  std::vector<std::uint32_t> surface;

  void fill(const Image& image, std::span<const std::uint16_t> surfaces, int y) {
    const float* const from = image.pixel(0, y);
    const auto width = static_cast<std::size_t>(image.width);
    surface.resize(width + 2);
    std::copy_n(&surfaces[std::size_t(y) * width], width, surface.begin() + 1);
    surface.front() = surface[1];
    surface.back() = surface[width];
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<float>& to = channel[c];
      to.resize(width + 2);
      for (std::size_t x = 0; x < width; ++x) {
        to[x + 1] = clamped(from[3 * x + c]);
      }
      to.front() = to[1];
      to.back() = to[width];
    }
  }
};

// Raises the contrast of each pixel to that with the pixel of `other` that is `step` to the right.
void raise(const Row& row, const Row& other, int step, RowOfContrasts& contrasts) {
  const float* const r = row.channel[0].data() + 1;
  const float* const g = row.channel[1].data() + 1;
  const float* const b = row.channel[2].data() + 1;
  const float* const other_r = other.channel[0].data() + 1 + step;
  const float* const other_g = other.channel[1].data() + 1 + step;
  const float* const other_b = other.channel[2].data() + 1 + step;
  const std::uint32_t* const surface = row.surface.data() + 1;
  const std::uint32_t* const other_surface = other.surface.data() + 1 + step;
  float* const most = contrasts.most.data();
  float* const edges = contrasts.edges.data();
  const std::size_t width = contrasts.most.size();
  for (std::size_t x = 0; x < width; ++x) {
    const float dr = r[x] - other_r[x];
    const float dg = g[x] - other_g[x];
    const float db = b[x] - other_b[x];
    const float all = (dr * dr + dg * dg + db * db) * third;
    const float edge = surface[x] == other_surface[x] ? all * on_one_surface : all;
    most[x] = most[x] < all ? all : most[x];
    edges[x] = edges[x] < edge ? edge : edges[x];
  }
}

}  // namespace

void raise(Contrast& contrast, const float* a, const float* b, bool one_surface) {
  const float dr = clamped(a[0]) - clamped(b[0]);
  const float dg = clamped(a[1]) - clamped(b[1]);
  const float db = clamped(a[2]) - clamped(b[2]);
  const float all = (dr * dr + dg * dg + db * db) * third;
  contrast.most = std::max(contrast.most, all);
  contrast.edges = std::max(contrast.edges, one_surface ? all * on_one_surface : all);
}

void for_each_row_of_contrasts(const Image& image, std::span<const std::uint16_t> surfaces,
                               const std::function<void(int, const RowOfContrasts&)>& row) {
  for_each_line(tiles_across(image.height), [&](int band) {
    const int first = band * tile_side;
    const int end = std::min(first + tile_side, image.height);
    Row rows[3];  // the one above, this one, the one below; by row number modulo 3
    for (int y = std::max(0, first - 1); y <= first; ++y) {
      rows[y % 3].fill(image, surfaces, y);
    }
    const auto width = static_cast<std::size_t>(image.width);
    RowOfContrasts contrasts{std::vector<float>(width), std::vector<float>(width)};
    for (int y = first; y < end; ++y) {
      const Row& here = rows[y % 3];
      std::fill(contrasts.most.begin(), contrasts.most.end(), 0.0f);
      std::fill(contrasts.edges.begin(), contrasts.edges.end(), 0.0f);
      if (y + 1 < image.height) {
        rows[(y + 1) % 3].fill(image, surfaces, y + 1);
      }
      for (int beside = std::max(0, y - 1); beside <= std::min(y + 1, image.height - 1); ++beside) {
        for (const int step : {-1, 0, 1}) {
          raise(here, rows[beside % 3], step, contrasts);
        }
      }
      row(y, contrasts);
    }
  });
}

}  // namespace scenefile
