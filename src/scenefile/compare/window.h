#pragma once
// Filters for pictures that are compared: row by row, so that what they keep fits in the cache, and
// only near pixels that differ. Internal to compare.

#include "scenefile/asset/image.h"
#include "scenefile/compare/lanes.h"

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

/// The pixels of a row with at least `reach` pixels on each side, which repeat the edges.
class PaddedRow {
 public:
  PaddedRow(int width, int reach) : width_(width), reach_(reach), values_(width + 2 * reach) {}
  float* pixels() { return values_.data() + reach_; }
  const float* pixels() const { return values_.data() + reach_; }
  /// To be called when all pixels are set.
  void repeat_edges();

 private:
  int width_;
  int reach_;
  std::vector<float> values_;
};

/// Rows of a plane and their weights, to be added up.
struct WeightedRows {
  std::vector<float> weights;
  std::vector<const float*> rows;

  void add(double weight, const float* row);
  /// to[x] = sum of weights[i] * rows[i][x] for the pixels of the span. If the weights sum to 0,
  /// the result is exactly 0 where all rows are equal.
  void add_up(const Span& span, float* to) const;
};

/// The last rows of a plane, filtered across.
class FilteredRows {
 public:
  /// Keeps the rows up to `reach` pixels above and below a row.
  FilteredRows(int width, int height, int reach, const Taps& across);
  void take(int y, const PaddedRow& row, const std::vector<Span>& spans);
  /// Adds the rows around `y` with the weights of a filter down; rows beyond the edge repeat it.
  void add_around(int y, const Taps& down, WeightedRows& rows) const;

 private:
  std::size_t start_of(int y) const;

  int width_;
  int height_;
  int kept_;
  Taps across_;
  std::vector<float> values_;
};

/// The pixels near those that differ between two pictures of the same size.
class NearDifferences {
 public:
  /// Within `across` and `down` pixels of a pixel that differs, and some more.
  NearDifferences(const Texture& a, const Texture& b, int across, int down);
  /// The same with `more` pixels down.
  NearDifferences grown_down(int more) const;
  std::vector<Span> spans(int y) const;

 private:
  int width_;
  int height_;
  int blocks_;                // per row
  std::vector<char> inside_;  // by block
};

}  // namespace scenefile
