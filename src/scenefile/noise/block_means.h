#pragma once
// Pictures as means of blocks, with the variances that noise gives them. Internal to noise.

#include "scenefile/noise/linearize.h"
#include "scenefile/noise/weighted_fit.h"
#include "scenefile/path/lamps.h"

#include <algorithm>
#include <vector>

namespace scenefile {

/// Visits x, y and the index of each pixel of block `b`.
template <typename Visit>
void for_each_pixel(const PathTruth& truth, std::size_t b, const Visit& visit) {
  const int left = static_cast<int>(b) % truth.columns * block_side;
  const int top = static_cast<int>(b) / truth.columns * block_side;
  for (int y = top; y < std::min(top + block_side, truth.height); ++y) {
    for (int x = left; x < std::min(left + block_side, truth.width); ++x) {
      visit(x, y, std::size_t(y) * truth.width + x);
    }
  }
}

/// The pixel in the middle of block `b`; the last of a row or column may be smaller than others.
inline glm::ivec2 middle_of(const PathTruth& truth, std::size_t b) {
  const int left = static_cast<int>(b) % truth.columns * block_side;
  const int top = static_cast<int>(b) / truth.columns * block_side;
  return {(left + std::min(left + block_side, truth.width)) / 2,
          (top + std::min(top + block_side, truth.height)) / 2};
}

/// The block of a pixel.
inline std::size_t block_of(const PathTruth& truth, std::size_t pixel) {
  const std::size_t x = pixel % truth.width;
  const std::size_t y = pixel / truth.width;
  return y / block_side * truth.columns + x / block_side;
}

/// 0 without values.
double median_of(std::vector<double> values);

/// Half of the value, half of the mean of the blocks around it.
BlockColors shrunk(const BlockColors& values, int columns);

/// a + by * b
BlockColors combined(const BlockColors& a, double by, const BlockColors& b);

/// What does not depend on the picture under test.
class TruthBlocks {
 public:
  explicit TruthBlocks(const PathTruth& t);

  template <typename Holds>
  BlockColors sum(const Holds& holds) const {
    BlockColors result = zero;
    for (const auto& [kind, light] : truth.kinds) {
      if (holds(kind)) {
        for (std::size_t b = 0; b < result.size(); ++b) {
          result[b] += light[b];
        }
      }
    }
    return result;
  }

  template <typename Factor>
  BlockColors scaled_kinds(const Factor& factor, bool of_hits) const {
    BlockColors result = zero;
    for (const auto& [kind, light] : truth.kinds) {
      if (kind.hit == of_hits) {
        const double by = factor(kind);
        for (std::size_t b = 0; b < result.size(); ++b) {
          result[b] += by * light[b];
        }
      }
    }
    return result;
  }

  /// Sum of the luminance outside of blocks that are left out.
  double energy(const BlockColors& light) const {
    double sum_of = 0;
    for (std::size_t b = 0; b < light.size(); ++b) {
      sum_of += left_out[b] == 0 ? luminance(light[b]) : 0;
    }
    return sum_of;
  }

  const PathTruth& truth;
  BlockColors zero;
  BlockColors lamp;  ///< seen by the camera
  BlockColors hit;   // other hits
  BlockColors sampled;
  BlockColors all;
  BlockColors variance;  ///< of a sample of a pixel
  BlockColors truth_noise;
  BlockColors gradient_x;
  BlockColors gradient_y;
  BlockColors edge;  ///< variance by edges
  std::vector<double> pixels;
  std::vector<char> left_out;
};

/// The picture as means of blocks.
struct ObservedBlocks {
  MeasuredBlocks measured;
  BlockColors cautious;       // weights that also know how much the picture itself varies
  BlockColors unrelated;      ///< variances that do not become less with more samples
  double per_sample = 1;      // variance of a pixel, relative to that of a sample of the truth
  double relative_noise = 0;  ///< median of the blocks: standard error / mean
  /// Of values of 8 bits: the mean logarithm of variance / variance by rounding. It compares the
  /// fits of several tone curves, as it has the units of the file.
  double log_variance = 0;
  std::size_t clipped = 0;
  std::size_t tested = 0;
};

/// `brighter`: an exposure that the picture still has. The noise of the truth then has other units
/// than the file, which matters for log_variance.
ObservedBlocks observe(const TruthBlocks& back, const LinearPicture& picture, double brighter = 1);

/// How the blocks change with a shift of the picture to the right, and down; directions in which
/// nothing changes are left out.
std::vector<const BlockColors*> gradients(const TruthBlocks& back, const MeasuredBlocks& measured);

}  // namespace scenefile
