#pragma once
// Statistical tests. The numbers are pseudorandom with fixed seeds, so results never change.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace scenefile::path_test {

/// Uniform in [0, 1), the same on all platforms.
class Uniform {
 public:
  explicit Uniform(std::uint32_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_()) / 4294967296.0; }

 private:
  std::mt19937 engine_;
};

/// The two-sided quantile of the normal distribution at which one of `tests` independent tests
/// fails with probability 0.001 (Sidak).
inline double sidak_bound(int tests) {
  const double tail = (1 - std::pow(1 - 0.001, 1.0 / tests)) / 2;
  double low = 0, high = 10;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (std::erfc(middle / std::sqrt(2.0)) / 2 > tail ? low : high) = middle;
  }
  return low;
}

/// Pearson's chi-square test, as a normal deviate (Wilson and Hilferty, 1931). Cells that expect
/// less than 5 are pooled.
inline double chi_square_deviate(const std::vector<double>& counts,
                                 const std::vector<double>& expected) {
  double sum = 0, pooled_count = 0, pooled = 0;
  int cells = -1;
  const auto add = [&](double count, double mean) {
    sum += (count - mean) * (count - mean) / mean;
    ++cells;
  };
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (expected[i] < 5) {
      pooled_count += counts[i];
      pooled += expected[i];
    } else {
      add(counts[i], expected[i]);
    }
  }
  if (pooled >= 5) {
    add(pooled_count, pooled);
  } else {
    EXPECT_LT(pooled_count, pooled + 25) << "in cells that expect almost nothing";
  }
  EXPECT_GE(cells, 1);
  const double spread = 2.0 / (9 * cells);
  return (std::cbrt(sum / cells) - (1 - spread)) / std::sqrt(spread);
}

}  // namespace scenefile::path_test
