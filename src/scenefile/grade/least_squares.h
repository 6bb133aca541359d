#pragma once
// Normal equations of least squares. Internal to grade.

#include <vector>

namespace scenefile {

/// Solves a symmetric positive definite system by Cholesky's method; empty if it is singular.
std::vector<double> solved(std::vector<std::vector<double>> a, std::vector<double> b);

}  // namespace scenefile
