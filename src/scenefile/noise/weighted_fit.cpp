#include "scenefile/noise/weighted_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scenefile {

namespace {

using DenseMatrix = std::vector<std::vector<double>>;

// The inverse of a symmetric positive matrix by Gauss and Jordan; empty if it is singular.
DenseMatrix inverse_of(DenseMatrix a) {
  const std::size_t n = a.size();
  DenseMatrix result(n, std::vector<double>(n));
  std::vector<double> scale(n);
  for (std::size_t i = 0; i < n; ++i) {
    scale[i] = a[i][i] > 0 ? 1 / std::sqrt(a[i][i]) : 1;
    result[i][i] = 1;
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      a[i][j] *= scale[i] * scale[j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!(a[i][i] > 1e-9)) {
      return {};
    }
    const double pivot = a[i][i];
    for (std::size_t j = 0; j < n; ++j) {
      a[i][j] /= pivot;
      result[i][j] /= pivot;
    }
    for (std::size_t k = 0; k < n; ++k) {
      const double by = a[k][i];
      for (std::size_t j = 0; j < n && k != i; ++j) {
        a[k][j] -= by * a[i][j];
        result[k][j] -= by * result[i][j];
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      result[i][j] *= scale[i] * scale[j];
    }
  }
  return result;
}

}  // namespace

BlockFit fit(const MeasuredBlocks& measured, const BlockColors& fixed,
             std::span<const BlockColors* const> free) {
  const std::size_t n = free.size();
  const std::size_t blocks = measured.mean.size();
  DenseMatrix normal(n, std::vector<double>(n));
  std::vector<double> right(n);
  for (std::size_t b = 0; b < blocks; ++b) {
    const Color wr = measured.weight[b] * (measured.mean[b] - fixed[b]);
    for (std::size_t i = 0; i < n; ++i) {
      const Color& x = (*free[i])[b];
      right[i] += glm::dot(x, wr);
      for (std::size_t j = 0; j <= i; ++j) {
        normal[i][j] += glm::dot(x * measured.weight[b], (*free[j])[b]);
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      normal[j][i] = normal[i][j];
    }
  }
  BlockFit result;
  const DenseMatrix inverse = inverse_of(normal);
  result.solved = inverse.size() == n;
  result.factors.resize(n);
  result.errors.resize(n);
  for (std::size_t i = 0; i < n && result.solved; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      result.factors[i] += inverse[i][j] * right[j];
    }
  }
  DenseMatrix meat(n, std::vector<double>(n));
  std::vector<double> score(n);
  for (std::size_t b = 0; b < blocks; ++b) {
    Color rest = measured.mean[b] - fixed[b];
    for (std::size_t i = 0; i < n; ++i) {
      rest -= result.factors[i] * (*free[i])[b];
    }
    const Color weighted = measured.weight[b] * rest;
    result.chi2 += glm::dot(weighted, rest);
    for (std::size_t i = 0; i < n; ++i) {
      score[i] = glm::dot((*free[i])[b], weighted);
      for (std::size_t j = 0; j <= i; ++j) {
        meat[i][j] += score[i] * score[j];
        meat[j][i] = meat[i][j];
      }
    }
  }
  for (std::size_t i = 0; i < n && result.solved; ++i) {
    double robust = 0;
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < n; ++k) {
        robust += inverse[i][j] * meat[j][k] * inverse[k][i];
      }
    }
    result.errors[i] = std::sqrt(std::max(robust, 3 * inverse[i][i]));
  }
  return result;
}

double critical_value(double level, double tests) {
  const double each = -std::expm1(std::log1p(-level) / std::max(1.0, tests));
  double low = 0;
  double high = 40;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (std::erfc(middle / std::numbers::sqrt2) > each ? low : high) = middle;
  }
  return low;
}

}  // namespace scenefile
