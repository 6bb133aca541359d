#pragma once
// Filters for two pictures that are compared: tile by tile, so that what is kept fits in the cache,
// and only where they differ. The loops are plain; compilers vectorize them. Internal to compare.

#include "scenefile/asset/image.h"

#include <cstddef>
#include <vector>

namespace scenefile {

/// A filter along one axis: an odd number of weights, centered on the pixel.
using Taps = std::vector<double>;

/// exp(-x^2 / (2 sigma^2)) for x from -radius to radius, not normalized.
Taps gaussian_taps(int radius, double sigma);
double sum_of(const Taps& taps);
/// Each weight times `factor`.
Taps scaled_taps(Taps taps, double factor);

/// A value for each pixel, row by row.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values;

  Plane(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * h) {}
  float* row(int y) { return values.data() + static_cast<std::size_t>(y) * width; }
  const float* row(int y) const { return values.data() + static_cast<std::size_t>(y) * width; }
};

/// A part of two pictures.
struct PlaneTile {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  int reach = 0;  ///< pixels on each side that filters use

  Plane with_surroundings() const { return {width + 2 * reach, height + 2 * reach}; }
  /// A pixel of the picture, by its column and row in a plane with the surroundings. Those beyond
  /// the picture repeat its edge.
  const std::uint8_t* texel(const Texture& picture, int column, int row) const;
};

/// Tiles with all pixels that are at most `reach` pixels away from a difference.
std::vector<PlaneTile> differing_tiles(const Texture& a, const Texture& b, int reach);

/// The pixels of the tile after filtering a plane with its surroundings in both directions. If the
/// weights sum to 0, so do equal pixels, exactly.
Plane filtered(const Plane& plane, const PlaneTile& tile, const Taps& across, const Taps& down);

}  // namespace scenefile
