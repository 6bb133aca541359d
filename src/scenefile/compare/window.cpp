#include "scenefile/compare/window.h"

#include <algorithm>
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

Plane filtered_rows(const Plane& plane, const Taps& taps) {
  const std::vector<int> from = clamped_places(plane.width, static_cast<int>(taps.size()) / 2);
  Plane result(plane.width, plane.height);
  for (int y = 0; y < plane.height; ++y) {
    for (int x = 0; x < plane.width; ++x) {
      double sum = 0;
      for (std::size_t i = 0; i < taps.size(); ++i) {
        sum += taps[i] * plane.at(from[x + i], y);
      }
      result.at(x, y) = static_cast<float>(sum);
    }
  }
  return result;
}

// Row by row, to read memory in order.
Plane filtered_columns(const Plane& plane, const Taps& taps) {
  const std::vector<int> from = clamped_places(plane.height, static_cast<int>(taps.size()) / 2);
  Plane result(plane.width, plane.height);
  std::vector<double> sums(plane.width);
  for (int y = 0; y < plane.height; ++y) {
    std::fill(sums.begin(), sums.end(), 0.0);
    for (std::size_t i = 0; i < taps.size(); ++i) {
      for (int x = 0; x < plane.width; ++x) {
        sums[x] += taps[i] * plane.at(x, from[y + i]);
      }
    }
    for (int x = 0; x < plane.width; ++x) {
      result.at(x, y) = static_cast<float>(sums[x]);
    }
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
