#include "scenefile/compare/lanes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

// The loader chooses the variant for the machine. Sanitizers are not ready that early.
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define SCENEFILE_ALL_LANES __attribute__((target_clones("avx2", "default")))
#else
#define SCENEFILE_ALL_LANES
#endif
// Must become part of each variant.
#define SCENEFILE_INLINE [[gnu::always_inline]] inline

namespace scenefile {

namespace {

// log2(x) for normal x > 0, with an error of 2e-7.
SCENEFILE_INLINE float log_2(float x) {
  const auto bits = std::bit_cast<std::int32_t>(x);
  // x = 2^exponent * m with m in [sqrt(1/2), sqrt(2))
  const std::int32_t exponent = (bits - 0x3f3504f3) >> 23;
  const auto m = std::bit_cast<float>(bits - exponent * (1 << 23));
  // log(m) = 2 artanh(s)
  const float s = (m - 1) / (m + 1);
  const float q = s * s;
  constexpr float two_over_log_2 = 2.88539008F;
  const float series = 1 + q * (1 / 3.0F + q * (1 / 5.0F + q * (1 / 7.0F + q * (1 / 9.0F))));
  return static_cast<float>(exponent) + two_over_log_2 * s * series;
}

// 2^x for x in [-126, 127], with a relative error of 2e-7.
SCENEFILE_INLINE float exp_2(float x) {
  constexpr float to_integer = 12582912.0F;  // 1.5 * 2^23: the sum has no fraction
  const float whole = (x + to_integer) - to_integer;
  const float t = 0.693147181F * (x - whole);
  const float power =
      1 +
      t * (1 + t * (1 / 2.0F +
                    t * (1 / 6.0F + t * (1 / 24.0F + t * (1 / 120.0F +
                                                          t * (1 / 720.0F + t * (1 / 5040.0F)))))));
  return power * std::bit_cast<float>((static_cast<std::int32_t>(whole) + 127) * (1 << 23));
}

// x^exponent for x in [0, 2^100] and an exponent in [0, 1].
SCENEFILE_INLINE float power(float x, float exponent) {
  const float result = exp_2(exponent * log_2(std::max(x, 1e-30F)));
  return x > 0 ? result : 0;
}

// The cube root of x > 0.001: a guess from the exponent, and Halley's method.
SCENEFILE_INLINE float cube_root(float x) {
  float y = std::bit_cast<float>(
      static_cast<std::int32_t>(static_cast<float>(std::bit_cast<std::int32_t>(x)) * (1 / 3.0F)) +
      0x2a514067);
  for (int i = 0; i < 2; ++i) {
    const float cube = y * y * y;
    y *= (cube + 2 * x) / (2 * cube + x);
  }
  return y;
}

SCENEFILE_INLINE float lab_curve(float t) {
  constexpr float delta = 6.0F / 29;
  constexpr float bend = delta * delta * delta;
  const float root = cube_root(std::max(t, bend));
  return t > bend ? root : t / (3 * delta * delta) + 4.0F / 29;
}

SCENEFILE_INLINE float limited(float value) {
  return std::min(std::max(value, 0.0F), 1.0F);
}

SCENEFILE_INLINE float row_times(const std::array<float, 3>& row, float x, float y, float z) {
  return row[0] * x + row[1] * y + row[2] * z;
}

using Lanes = float __attribute__((vector_size(32)));
constexpr int lanes = 8;

SCENEFILE_INLINE void load(Lanes& to, const float* from) {
  std::memcpy(&to, from, sizeof to);
}

template <bool subtract>
SCENEFILE_INLINE void add_up(const float* weights, const float* const* rows, std::size_t count,
                             const float* center, const Span& span, float* to) {
  constexpr int together = 4;  // sums that fit in registers
  int x = span.begin;
  for (; x + together * lanes <= span.end; x += together * lanes) {
    Lanes sums[together] = {};
    Lanes middle[together] = {};
    for (int k = 0; subtract && k < together; ++k) {
      load(middle[k], center + x + k * lanes);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Lanes weight = weights[i] - Lanes{};
      for (int k = 0; k < together; ++k) {
        Lanes values;
        load(values, rows[i] + x + k * lanes);
        sums[k] += weight * (subtract ? values - middle[k] : values);
      }
    }
    std::memcpy(to + x, sums, sizeof sums);
  }
  for (; x < span.end; ++x) {
    float sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      sum += weights[i] * (subtract ? rows[i][x] - center[x] : rows[i][x]);
    }
    to[x] = sum;
  }
}

}  // namespace

SCENEFILE_ALL_LANES
void weighted_sum(const float* weights, const float* const* rows, std::size_t count,
                  const Span& span, float* to) {
  add_up<false>(weights, rows, count, nullptr, span, to);
}

SCENEFILE_ALL_LANES
void weighted_differences(const float* weights, const float* const* rows, std::size_t count,
                          const float* center, const Span& span, float* to) {
  add_up<true>(weights, rows, count, center, span, to);
}

SCENEFILE_ALL_LANES
void rgb_to_ycxcz(const ColorMatrix& matrix, const Span& span, const Rows3& rows) {
  const ColorMatrix xyz = matrix;
  float* const r = rows[0];
  float* const g = rows[1];
  float* const b = rows[2];
  for (int i = span.begin; i < span.end; ++i) {
    const float x = row_times(xyz[0], r[i], g[i], b[i]);
    const float y = row_times(xyz[1], r[i], g[i], b[i]);
    const float z = row_times(xyz[2], r[i], g[i], b[i]);
    r[i] = 116 * y - 16;
    g[i] = 500 * (x - y);
    b[i] = 200 * (y - z);
  }
}

SCENEFILE_ALL_LANES
void ycxcz_to_hunt_lab(const ColorMatrix& to_xyz, const ColorMatrix& to_rgb, const Span& span,
                       const Rows3& rows) {
  const ColorMatrix xyz = to_xyz;
  const ColorMatrix rgb = to_rgb;
  float* const first = rows[0];
  float* const second = rows[1];
  float* const third = rows[2];
  for (int i = span.begin; i < span.end; ++i) {
    const float y = (first[i] + 16) / 116;
    const float x = y + second[i] / 500;
    const float z = y - third[i] / 200;
    const float r = limited(row_times(rgb[0], x, y, z));
    const float g = limited(row_times(rgb[1], x, y, z));
    const float b = limited(row_times(rgb[2], x, y, z));
    const float fx = lab_curve(row_times(xyz[0], r, g, b));
    const float fy = lab_curve(row_times(xyz[1], r, g, b));
    const float fz = lab_curve(row_times(xyz[2], r, g, b));
    const float lightness = 116 * fy - 16;
    first[i] = lightness;
    second[i] = 0.01F * lightness * 500 * (fx - fy);
    third[i] = 0.01F * lightness * 200 * (fy - fz);
  }
}

SCENEFILE_ALL_LANES
void flip_errors(const ColorErrorCurve& given, const FlipRow& a, const FlipRow& b, const Span& span,
                 float* to) {
  const ColorErrorCurve curve = given;
  const float below = curve.knee_value / curve.knee;
  const float above = (1 - curve.knee_value) / (curve.largest - curve.knee);
  const FlipRow p = a;
  const FlipRow q = b;
  for (int i = span.begin; i < span.end; ++i) {
    const float l = std::abs(p.lab[0][i] - q.lab[0][i]);
    const float u = p.lab[1][i] - q.lab[1][i];
    const float v = p.lab[2][i] - q.lab[2][i];
    const float hyab = power(l + std::sqrt(u * u + v * v), curve.exponent);  // the metric HyAB
    const float color =
        hyab < curve.knee ? below * hyab : curve.knee_value + above * (hyab - curve.knee);
    const float edges = std::abs(p.edges[i] - q.edges[i]);
    const float points = std::abs(p.points[i] - q.points[i]);
    const float feature = std::sqrt(std::max(edges, points) * 0.707106781F);
    to[i] = limited(power(color, 1 - limited(feature)));
  }
}

SCENEFILE_ALL_LANES
void lengths(const Span& span, float* x, const float* y) {
  for (int i = span.begin; i < span.end; ++i) {
    x[i] = std::sqrt(x[i] * x[i] + y[i] * y[i]);
  }
}

SCENEFILE_ALL_LANES
void dissimilarities(const SsimConstants& given, const MeanRow& means, const Span& span,
                     float* to) {
  const SsimConstants constants = given;
  const MeanRow mean = means;
  for (int i = span.begin; i < span.end; ++i) {
    const float s = mean.s[i];
    const float d = mean.d[i];
    const float full = s + constants.middle;
    // Of a and b, 2 E[a] E[b] and E[a]^2 + E[b]^2 are 2 full^2 -+ d^2 / 2; likewise of
    // (co)variances.
    const float light = d * d / (2 * full * full + d * d / 2 + constants.c1);
    const float spread = mean.dd[i] - d * d;
    const float structure = spread / (2 * (mean.ss[i] - s * s) + spread / 2 + constants.c2);
    to[i] = light + structure - light * structure;
  }
}

}  // namespace scenefile
