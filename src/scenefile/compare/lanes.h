#pragma once
// The loops over the pixels of a row, compiled for several instruction sets, with the same results.
// Internal to compare.

#include <array>
#include <cstddef>

namespace scenefile {

/// Pixels of a row, from `begin` up to, but not including, `end`.
struct Span {
  int begin = 0;
  int end = 0;
};

/// to[x] = sum of weights[i] * rows[i][x] for the pixels of the span.
void weighted_sum(const float* weights, const float* const* rows, std::size_t count,
                  const Span& span, float* to);

/// The same for weights that sum to 0: exactly 0 where all rows are equal. `center`: one of the
/// rows.
void weighted_differences(const float* weights, const float* const* rows, std::size_t count,
                          const float* center, const Span& span, float* to);

/// The rows of three planes.
using Rows3 = std::array<float*, 3>;

/// A linear map of colors, by rows.
using ColorMatrix = std::array<std::array<float, 3>, 3>;

/// From linear sRGB to the opponent space YCxCz, in place. `xyz`: to CIE XYZ relative to white.
void rgb_to_ycxcz(const ColorMatrix& xyz, const Span& span, const Rows3& rows);

/// From YCxCz to CIELAB with chroma that fades with lightness (Hunt effect), in place. Colors are
/// limited to sRGB. `rgb`: the inverse of `xyz`.
void ycxcz_to_hunt_lab(const ColorMatrix& xyz, const ColorMatrix& rgb, const Span& span,
                       const Rows3& rows);

/// FLIP's mapping of color errors (its section 4.2.2).
struct ColorErrorCurve {
  float exponent = 1;
  float knee = 1;        ///< the error at the knee, after raising it to the exponent, ...
  float knee_value = 1;  ///< ... is mapped to this,
  float largest = 1;     ///< and this is mapped to 1
};

/// What FLIP compares: colors in CIELAB, and the strengths of edges and points.
struct FlipRow {
  Rows3 lab;
  const float* edges;
  const float* points;
};

/// The FLIP error of each pixel, in [0, 1]; the exponent of feature errors is 1/2 (section 4.3).
void flip_errors(const ColorErrorCurve& curve, const FlipRow& a, const FlipRow& b, const Span& span,
                 float* to);

/// sqrt(x^2 + y^2), in x.
void lengths(const Span& span, float* x, const float* y);

/// Weighted means around each pixel of s = (a + b) / 2 - middle and d = a - b, and their squares.
struct MeanRow {
  const float* s;
  const float* d;
  const float* ss;
  const float* dd;
};

/// The constants of SSIM, and what was subtracted from s.
struct SsimConstants {
  float c1 = 0;
  float c2 = 0;
  float middle = 0;
};

/// 1 - SSIM of each pixel. With these means instead of those of a and b, similar pictures lose no
/// precision.
void dissimilarities(const SsimConstants& constants, const MeanRow& means, const Span& span,
                     float* to);

}  // namespace scenefile
