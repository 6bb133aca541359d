#include "scenefile/trace/edges.h"

#include "scenefile/trace/tiles.h"

#include <algorithm>
#include <vector>

namespace scenefile {

namespace {

constexpr float third = 1.0f / 3;

// The factor for squared differences within one surface.
constexpr float on_one_surface = third / 32;

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

// Raises each value of `most` to the contrast with the pixel of `other` that is `step` to the
// right.
void raise(const Row& row, const Row& other, int step, std::vector<float>& most) {
  const float* const r = row.channel[0].data() + 1;
  const float* const g = row.channel[1].data() + 1;
  const float* const b = row.channel[2].data() + 1;
  const float* const other_r = other.channel[0].data() + 1 + step;
  const float* const other_g = other.channel[1].data() + 1 + step;
  const float* const other_b = other.channel[2].data() + 1 + step;
  const std::uint32_t* const surface = row.surface.data() + 1;
  const std::uint32_t* const other_surface = other.surface.data() + 1 + step;
  float* const to = most.data();
  const std::size_t width = most.size();
  for (std::size_t x = 0; x < width; ++x) {
    const float dr = r[x] - other_r[x];
    const float dg = g[x] - other_g[x];
    const float db = b[x] - other_b[x];
    const float share = surface[x] == other_surface[x] ? on_one_surface : third;
    const float sum = (dr * dr + dg * dg + db * db) * share;
    to[x] = to[x] < sum ? sum : to[x];
  }
}

}  // namespace

float contrast(const float* a, const float* b, bool one_surface) {
  const float dr = clamped(a[0]) - clamped(b[0]);
  const float dg = clamped(a[1]) - clamped(b[1]);
  const float db = clamped(a[2]) - clamped(b[2]);
  return (dr * dr + dg * dg + db * db) * (one_surface ? on_one_surface : third);
}

void for_each_row_of_contrasts(const Image& image, std::span<const std::uint16_t> surfaces,
                               const std::function<void(int, std::span<const float>)>& row) {
  for_each_line(tiles_across(image.height), [&](int band) {
    const int first = band * tile_side;
    const int end = std::min(first + tile_side, image.height);
    Row rows[3];  // the one above, this one, the one below; by row number modulo 3
    for (int y = std::max(0, first - 1); y <= first; ++y) {
      rows[y % 3].fill(image, surfaces, y);
    }
    std::vector<float> most(static_cast<std::size_t>(image.width));
    for (int y = first; y < end; ++y) {
      const Row& here = rows[y % 3];
      std::fill(most.begin(), most.end(), 0.0f);
      if (y + 1 < image.height) {
        rows[(y + 1) % 3].fill(image, surfaces, y + 1);
      }
      for (int beside = std::max(0, y - 1); beside <= std::min(y + 1, image.height - 1); ++beside) {
        for (const int step : {-1, 0, 1}) {
          raise(here, rows[beside % 3], step, most);
        }
      }
      row(y, most);
    }
  });
}

}  // namespace scenefile
