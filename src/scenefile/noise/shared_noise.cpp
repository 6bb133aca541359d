#include "scenefile/noise/shared_noise.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

bool has_shared_noise(const TruthBlocks& back, const Reading& reading, const PathVerdict& verdict,
                      double places_chi2) {
  constexpr double not_noise = 3;  // times the variance of noise, as for mistakes
  std::vector<double> sizes;
  double sum = 0;
  double squares = 0;
  double largest = 0;
  for (std::size_t b = 0; b < verdict.significance.size(); ++b) {
    if (verdict.errors[b] > 0) {
      const double z = verdict.significance[b];
      sizes.push_back(std::abs(z));
      sum += z;
      squares += z * z;
      largest = std::max(largest, std::abs(z));
    }
  }
  const auto n = static_cast<double>(sizes.size());
  const double typical = median_of(std::move(sizes)) / 0.6745;  // of normal values
  constexpr double fewest = 64;  // for a correlation of 0.25 to be 2 standard errors
  if (n < fewest || typical * typical < not_noise || largest > 5 * typical) {
    return false;
  }
  const double mean = sum / n;
  const double variance = squares / n - mean * mean;
  // The fraction of the difference that factors of kinds of light explain, and the mean.
  constexpr double most_common = 0.25;
  if (mean * mean > most_common * squares / n || places_chi2 < 0.5 * reading.right.fit.chi2) {
    return false;
  }
  // A sixth of the picture away, as walls and shadows are not smaller.
  const auto correlation = [&](int right, int down) {
    double product = 0;
    double count = 0;
    for (int y = 0; y + down < back.truth.rows; ++y) {
      for (int x = 0; x + right < back.truth.columns; ++x) {
        const std::size_t i = std::size_t(y) * back.truth.columns + x;
        const std::size_t j = std::size_t(y + down) * back.truth.columns + x + right;
        if (verdict.errors[i] > 0 && verdict.errors[j] > 0) {
          product += (verdict.significance[i] - mean) * (verdict.significance[j] - mean);
          ++count;
        }
      }
    }
    return count > 0 ? product / count / variance : 1;
  };
  return std::max(correlation(std::max(2, back.truth.columns / 6), 0),
                  correlation(0, std::max(2, back.truth.rows / 6))) < most_common;
}

}  // namespace scenefile
