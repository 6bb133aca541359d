#pragma once
// Planes of numbers, and filters for them.

#include <vector>

namespace scenefile {

/// One number per pixel, row by row.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values;

  Plane() = default;
  Plane(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * h) {}
  float& at(int x, int y) { return values[static_cast<std::size_t>(width) * y + x]; }
  float at(int x, int y) const { return values[static_cast<std::size_t>(width) * y + x]; }
};

/// A filter along one axis: an odd number of weights, centered on the pixel.
using Taps = std::vector<double>;

/// exp(-x^2 / (2 sigma^2)) for x from -radius to radius, not normalized.
Taps gaussian_taps(int radius, double sigma);
double sum_of(const Taps& taps);

/// Correlates rows with `across`, then columns with `down`. Pixels beyond the edge repeat the edge.
Plane filtered(const Plane& plane, const Taps& across, const Taps& down);

}  // namespace scenefile
