#pragma once
// Weighted least squares over blocks, with standard errors that remain valid if the estimate of the
// noise is wrong.
// Internal to noise.

#include "scenefile/noise/path_truth.h"

#include <span>
#include <vector>

namespace scenefile {

/// Means of blocks, and 1 / variance of each; 0: left out.
struct MeasuredBlocks {
  BlockColors mean;
  BlockColors weight;
};

struct BlockFit {
  std::vector<double> factors;  ///< of the free columns
  /// Standard errors: the larger of that by the weights, for channels with the same noise, and the
  /// one of the residuals (White, "A Heteroskedasticity-Consistent Covariance Matrix Estimator",
  /// 1980, with a block as one observation).
  std::vector<double> errors;
  double chi2 = 0;  ///< sum of weight * residual^2
  bool solved = false;
};

/// Fits mean = fixed + sum of factors * free.
BlockFit fit(const MeasuredBlocks& measured, const BlockColors& fixed,
             std::span<const BlockColors* const> free);

/// The two-sided normal quantile at which none of `tests` independent tests is expected to exceed
/// it with probability 1 - level (Sidak, 1967).
double critical_value(double level, double tests);

}  // namespace scenefile
