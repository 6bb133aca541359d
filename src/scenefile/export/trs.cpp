#include "scenefile/export/trs.h"

#include <cmath>

namespace scenefile {

namespace {

constexpr double orthogonal_to = 1e-7;  // cosine; smaller ones count as orthogonal
constexpr int max_sweeps = 60;

bool orthogonal(const glm::dvec3& a, const glm::dvec3& b, double cosine) {
  return std::abs(glm::dot(a, b)) <= cosine * glm::length(a) * glm::length(b);
}

// One-sided Jacobi: rotates columns p and q of `b` until they are orthogonal, and applies the same
// rotation to `v`. (G. Golub, C. Van Loan, Matrix Computations, section 8.6.3.)
void make_orthogonal(glm::dmat3& b, glm::dmat3& v, int p, int q) {
  const double alpha = glm::dot(b[p], b[p]);
  const double beta = glm::dot(b[q], b[q]);
  const double gamma = glm::dot(b[p], b[q]);
  const double zeta = (beta - alpha) / (2 * gamma);
  const double t = std::copysign(1.0, zeta) / (std::abs(zeta) + std::sqrt(1 + zeta * zeta));
  const double c = 1 / std::sqrt(1 + t * t);
  const double s = c * t;
  for (glm::dmat3* m : {&b, &v}) {
    const glm::dvec3 column = (*m)[p];
    (*m)[p] = c * column - s * (*m)[q];
    (*m)[q] = s * column + c * (*m)[q];
  }
}

// Splits orthogonal columns into lengths and a rotation. A reflection negates the first length.
void split(const glm::dmat3& columns, Trs& trs) {
  glm::dmat3 unit(1);
  for (int i = 0; i < 3; ++i) {
    trs.scale[i] = glm::length(columns[i]);
    unit[i] = columns[i] / trs.scale[i];
  }
  if (glm::determinant(unit) < 0) {
    trs.scale.x = -trs.scale.x;
    unit[0] = -unit[0];
  }
  trs.rotation = glm::normalize(glm::quat_cast(unit));
}

}  // namespace

TrsPair decompose(const DAffine& map) {
  TrsPair pair;
  pair.outer.translation = map.offset;
  glm::dmat3 b = map.linear;
  glm::dmat3 v(1);
  constexpr int pairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  const auto done = [&](double cosine) {
    return orthogonal(b[0], b[1], cosine) && orthogonal(b[0], b[2], cosine) &&
           orthogonal(b[1], b[2], cosine);
  };
  if (!done(orthogonal_to)) {
    for (int sweep = 0; sweep < max_sweeps && !done(1e-15); ++sweep) {
      for (const auto& [p, q] : pairs) {
        if (!orthogonal(b[p], b[q], 1e-15)) {
          make_orthogonal(b, v, p, q);
        }
      }
    }
    // map = b * transpose(v)
    pair.inner = glm::normalize(glm::quat_cast(glm::transpose(v)));
  }
  split(b, pair.outer);
  return pair;
}

}  // namespace scenefile
