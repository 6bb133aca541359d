#include "scenefile/compare/window.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace scenefile {

namespace {

// The index that each tap reads for each pixel along an axis of `size` pixels.
std::vector<int> clamped_places(int size, int radius) {
  std::vector<int> places(static_cast<std::size_t>(size) + 2 * radius);
  for (int i = 0; i < static_cast<int>(places.size()); ++i) {
    places[i] = std::clamp(i - radius, 0, size - 1);
  }
  return places;
}

// to[x] = sum of taps[i] * sources[i][x] for `count` pixels, whose sums fit in registers.
template <int count>
void add_up(const Taps& taps, const std::vector<const float*>& sources, int x, float* to) {
  std::array<double, count> sums{};
  for (std::size_t i = 0; i < taps.size(); ++i) {
    const double tap = taps[i];
    const float* const from = sources[i] + x;
    for (int k = 0; k < count; ++k) {
      sums[k] += tap * from[k];
    }
  }
  std::copy(sums.begin(), sums.end(), to + x);
}

void add_up_row(const Taps& taps, const std::vector<const float*>& sources, int width, float* to) {
  constexpr int block = 8;
  int x = 0;
  for (; x + block <= width; x += block) {
    add_up<block>(taps, sources, x, to);
  }
  for (; x < width; ++x) {
    add_up<1>(taps, sources, x, to);
  }
}

Plane filtered_rows(const Plane& plane, const Taps& taps) {
  const std::vector<int> from = clamped_places(plane.width, static_cast<int>(taps.size()) / 2);
  std::vector<float> row(from.size());  // repeats the edges
  std::vector<const float*> sources;
  for (std::size_t i = 0; i < taps.size(); ++i) {
    sources.push_back(row.data() + i);
  }
  Plane result(plane.width, plane.height);
  for (int y = 0; y < plane.height; ++y) {
    std::transform(from.begin(), from.end(), row.begin(), [&](int x) { return plane.at(x, y); });
    add_up_row(taps, sources, plane.width, &result.at(0, y));
  }
  return result;
}

Plane filtered_columns(const Plane& plane, const Taps& taps) {
  const std::vector<int> from = clamped_places(plane.height, static_cast<int>(taps.size()) / 2);
  std::vector<const float*> sources(taps.size());
  Plane result(plane.width, plane.height);
  for (int y = 0; y < plane.height; ++y) {
    for (std::size_t i = 0; i < taps.size(); ++i) {
      sources[i] = &plane.values[static_cast<std::size_t>(plane.width) * from[y + i]];
    }
    add_up_row(taps, sources, plane.width, &result.at(0, y));
  }
  return result;
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

Plane filtered(const Plane& plane, const Taps& across, const Taps& down) {
  return filtered_columns(filtered_rows(plane, across), down);
}

}  // namespace scenefile
