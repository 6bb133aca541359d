#include "scenefile/compare/flip.h"

#include "scenefile/compare/planes.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

namespace scenefile {

namespace {

using std::numbers::pi;

// Exponent and knee of the color error (sections 4.1.4 and 4.2.2 of the paper).
constexpr double color_exponent = 0.7;
constexpr double knee_share = 0.4;       // share of the largest color error ...
constexpr double knee_value = 0.95;      // ... that is mapped to this
constexpr double feature_width = 0.082;  // degrees

// Rows of the matrix from linear sRGB to CIE XYZ (D65).
constexpr std::array<std::array<double, 3>, 3> xyz_rows{
    {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
     {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
     {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

// By rows.
using ColorMatrix = std::array<std::array<float, 3>, 3>;

// From linear sRGB to XYZ relative to white, and back.
struct ColorSpaces {
  ColorMatrix xyz{};
  ColorMatrix rgb{};

  ColorSpaces() {
    glm::dmat3 m;  // transposed
    for (int row = 0; row < 3; ++row) {
      const glm::dvec3 of_row(xyz_rows[row][0], xyz_rows[row][1], xyz_rows[row][2]);
      m[row] = of_row / (of_row.x + of_row.y + of_row.z);
    }
    const glm::dmat3 inverse = glm::inverse(m);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        xyz[row][column] = static_cast<float>(m[row][column]);
        rgb[row][column] = static_cast<float>(inverse[row][column]);
      }
    }
  }
};

double linear_from_srgb(double value) {
  return value > 0.04045 ? std::pow((value + 0.055) / 1.055, 2.4) : value / 12.92;
}

// A Gaussian of the contrast sensitivity functions: a sqrt(pi / b) exp(-(pi x)^2 / b), with x in
// degrees.
struct Sensitivity {
  double a = 1;
  double b = 1;
};

// Drops outer weights that are too small to change a sum of floats.
Taps shortened(const Taps& taps) {
  const std::size_t middle = taps.size() / 2;
  std::size_t radius = middle;
  while (radius > 0 && std::abs(taps[middle - radius]) < 1e-9 * std::abs(taps[middle])) {
    --radius;
  }
  return {taps.begin() + std::ptrdiff_t(middle - radius),
          taps.begin() + std::ptrdiff_t(middle + radius + 1)};
}

// Scales the weights so that positive ones sum to 1 and negative ones to -1.
Taps balanced(Taps taps) {
  double positive = 0;
  double negative = 0;
  for (const double tap : taps) {
    (tap > 0 ? positive : negative) += std::abs(tap);
  }
  for (double& tap : taps) {
    tap /= tap > 0 ? positive : negative;
  }
  return taps;
}

// A filter in both directions; a channel is filtered with a sum of these.
struct Filter {
  Taps across;
  Taps down;
};

// A channel as seen from this distance: a normalized sum of Gaussians.
std::vector<Filter> seen(const std::vector<Sensitivity>& sum, double pixels_per_degree) {
  constexpr double widest = 0.04;
  const double reach = 3 * std::sqrt(widest / (2 * pi * pi)) * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(reach));
  double total = 0;
  std::vector<Filter> filters;
  for (const Sensitivity& s : sum) {
    const Taps taps = gaussian_taps(radius, std::sqrt(s.b / 2) / pi * pixels_per_degree);
    const double weight = s.a * std::sqrt(pi / s.b);
    total += weight * sum_of(taps) * sum_of(taps);
    filters.push_back({shortened(taps), scaled_taps(shortened(taps), weight)});
  }
  for (Filter& filter : filters) {
    filter.down = scaled_taps(filter.down, 1 / total);
  }
  return filters;
}

// The filters of FLIP for a distance.
struct Filters {
  std::array<std::vector<Filter>, 3> channels;  // of YCxCz
  Taps smooth, edge, point;
  int reach = 0;                    // of the widest, in pixels
  std::array<float, 256> linear{};  // the values of 8-bit sRGB

  explicit Filters(double pixels_per_degree)
      : channels{seen({{1, 0.0047}}, pixels_per_degree), seen({{1, 0.0053}}, pixels_per_degree),
                 seen({{34.1, 0.04}, {13.5, 0.025}}, pixels_per_degree)} {
    const double sigma = 0.5 * feature_width * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const Taps taps = gaussian_taps(radius, sigma);
    edge = taps;
    point = taps;
    for (int x = -radius; x <= radius; ++x) {
      edge[x + radius] *= -x;
      point[x + radius] *= x * x / (sigma * sigma) - 1;
    }
    for (std::size_t i = 0; i < linear.size(); ++i) {
      linear[i] = static_cast<float>(linear_from_srgb(static_cast<double>(i) / 255));
    }
    smooth = scaled_taps(taps, 1 / sum_of(taps));
    // Of lightness in [0, 1]; Y is 116 times as much, and its offset has no edges.
    edge = scaled_taps(balanced(edge), 1 / 116.0);
    point = scaled_taps(balanced(point), 1 / 116.0);
    reach = radius;
    for (const std::vector<Filter>& sum : channels) {
      for (const Filter& filter : sum) {
        reach = std::max(reach, static_cast<int>(filter.across.size()) / 2);
      }
    }
  }
};

// log2(x) for normal x > 0, with an error of 2e-7.
inline float log_2(float x) {
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
inline float exp_2(float x) {
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

// x^exponent for x in [0, 2^100] and an exponent in [0, 1]. Unlike std::pow, compilers vectorize
// it.
inline float power(float x, float exponent) {
  const float result = exp_2(exponent * log_2(std::max(x, 1e-30F)));
  return x > 0 ? result : 0;
}

inline float limited(float value) {
  return std::min(std::max(value, 0.0F), 1.0F);
}

inline float row_times(const std::array<float, 3>& row, float x, float y, float z) {
  return row[0] * x + row[1] * y + row[2] * z;
}

inline float lab_curve(float t) {
  constexpr float delta = 6.0F / 29;
  constexpr float bend = delta * delta * delta;
  const float root = power(std::max(t, bend), 1 / 3.0F);
  return t > bend ? root : t / (3 * delta * delta) + 4.0F / 29;
}

// Three planes of a picture in one color space.
using Planes = std::array<Plane, 3>;

// From linear sRGB to the opponent space YCxCz, in place.
void rgb_to_ycxcz(const ColorSpaces& spaces, Planes& planes) {
  const ColorMatrix xyz = spaces.xyz;
  auto& [first, second, third] = planes;
  for (std::size_t i = 0; i < first.values.size(); ++i) {
    const float r = first.values[i];
    const float g = second.values[i];
    const float b = third.values[i];
    const float x = row_times(xyz[0], r, g, b);
    const float y = row_times(xyz[1], r, g, b);
    const float z = row_times(xyz[2], r, g, b);
    first.values[i] = 116 * y - 16;
    second.values[i] = 500 * (x - y);
    third.values[i] = 200 * (y - z);
  }
}

// From YCxCz to CIELAB with chroma that fades with lightness (Hunt effect), in place. Colors are
// limited to sRGB.
void ycxcz_to_hunt_lab(const ColorSpaces& spaces, Planes& planes) {
  const ColorMatrix xyz = spaces.xyz;
  const ColorMatrix rgb = spaces.rgb;
  auto& [first, second, third] = planes;
  for (std::size_t i = 0; i < first.values.size(); ++i) {
    const float y = (first.values[i] + 16) / 116;
    const float x = y + second.values[i] / 500;
    const float z = y - third.values[i] / 200;
    const float r = limited(row_times(rgb[0], x, y, z));
    const float g = limited(row_times(rgb[1], x, y, z));
    const float b = limited(row_times(rgb[2], x, y, z));
    const float fx = lab_curve(row_times(xyz[0], r, g, b));
    const float fy = lab_curve(row_times(xyz[1], r, g, b));
    const float fz = lab_curve(row_times(xyz[2], r, g, b));
    const float lightness = 116 * fy - 16;
    first.values[i] = lightness;
    second.values[i] = 0.01F * lightness * 500 * (fx - fy);
    third.values[i] = 0.01F * lightness * 200 * (fy - fz);
  }
}

// A tile of one of the pictures: what FLIP compares.
struct SeenTile {
  Planes lab;
  Plane edges;
  Plane points;
};

// The length of the gradient at each pixel, by the same filter in both directions.
Plane detected(const Plane& lightness, const PlaneTile& tile, const Taps& derivative,
               const Taps& smooth) {
  Plane across = filtered(lightness, tile, derivative, smooth);
  const Plane down = filtered(lightness, tile, smooth, derivative);
  for (std::size_t i = 0; i < across.values.size(); ++i) {
    const float x = across.values[i];
    const float y = down.values[i];
    across.values[i] = std::sqrt(x * x + y * y);
  }
  return across;
}

SeenTile seen_tile(const Texture& picture, const PlaneTile& tile, const Filters& filters,
                   const ColorSpaces& spaces) {
  const Plane empty = tile.with_surroundings();
  Planes input{empty, empty, empty};
  for (int y = 0; y < empty.height; ++y) {
    for (int x = 0; x < empty.width; ++x) {
      const std::uint8_t* const p = tile.texel(picture, x, y);
      for (std::size_t i = 0; i < input.size(); ++i) {
        input[i].row(y)[x] = filters.linear[p[i]];
      }
    }
  }
  rgb_to_ycxcz(spaces, input);
  const auto seen_channel = [&](std::size_t channel) {
    const std::vector<Filter>& sum = filters.channels[channel];
    Plane result = filtered(input[channel], tile, sum[0].across, sum[0].down);
    for (std::size_t k = 1; k < sum.size(); ++k) {
      const Plane other = filtered(input[channel], tile, sum[k].across, sum[k].down);
      std::transform(result.values.begin(), result.values.end(), other.values.begin(),
                     result.values.begin(), std::plus<>());
    }
    return result;
  };
  SeenTile seen{{seen_channel(0), seen_channel(1), seen_channel(2)},
                detected(input[0], tile, filters.edge, filters.smooth),
                detected(input[0], tile, filters.point, filters.smooth)};
  ycxcz_to_hunt_lab(spaces, seen.lab);
  return seen;
}

// FLIP's mapping of color errors to [0, 1] (section 4.2.2); the largest is that between green and
// blue.
struct ColorErrorCurve {
  float knee = 1;   // of the color error raised to color_exponent
  float below = 1;  // slopes below and above the knee
  float above = 1;

  explicit ColorErrorCurve(const ColorSpaces& spaces) {
    Planes colors{Plane(2, 1), Plane(2, 1), Plane(2, 1)};
    colors[1].values[0] = colors[2].values[1] = 1;
    rgb_to_ycxcz(spaces, colors);
    ycxcz_to_hunt_lab(spaces, colors);
    const auto difference = [&](int i) { return colors[i].values[0] - colors[i].values[1]; };
    const double hyab = std::abs(difference(0)) + std::hypot(difference(1), difference(2));
    const double largest = std::pow(hyab, color_exponent);
    knee = static_cast<float>(knee_share * largest);
    below = static_cast<float>(knee_value / (knee_share * largest));
    above = static_cast<float>((1 - knee_value) / (largest - knee_share * largest));
  }
};

// The error of each pixel, in [0, 1]; the exponent of feature errors is 1/2 (section 4.3).
Plane flip_errors(const ColorErrorCurve& given, const SeenTile& p, const SeenTile& q) {
  const ColorErrorCurve curve = given;
  Plane errors = p.edges;
  for (std::size_t i = 0; i < errors.values.size(); ++i) {
    const float l = std::abs(p.lab[0].values[i] - q.lab[0].values[i]);
    const float u = p.lab[1].values[i] - q.lab[1].values[i];
    const float v = p.lab[2].values[i] - q.lab[2].values[i];
    // Raised to the exponent: the metric HyAB.
    const float hyab = power(l + std::sqrt(u * u + v * v), static_cast<float>(color_exponent));
    const float color = hyab < curve.knee
                            ? curve.below * hyab
                            : static_cast<float>(knee_value) + curve.above * (hyab - curve.knee);
    const float edges = std::abs(p.edges.values[i] - q.edges.values[i]);
    const float points = std::abs(p.points.values[i] - q.points.values[i]);
    const float feature = std::sqrt(std::max(edges, points) * 0.707106781F);
    errors.values[i] = limited(power(color, 1 - limited(feature)));
  }
  return errors;
}

}  // namespace

FlipMap flip(const Texture& reference, const Texture& test, double pixels_per_degree) {
  FlipMap map;
  if (reference.width != test.width || reference.height != test.height || reference.empty()) {
    map.mean = map.max = reference.empty() && test.empty() ? 0 : 1;
    return map;
  }
  const ColorSpaces spaces;
  const ColorErrorCurve curve(spaces);
  const Filters filters(pixels_per_degree);
  map.errors.resize(static_cast<std::size_t>(test.width) * test.height);
  for (const PlaneTile& tile : differing_tiles(reference, test, filters.reach)) {
    const Plane errors = flip_errors(curve, seen_tile(reference, tile, filters, spaces),
                                     seen_tile(test, tile, filters, spaces));
    for (int y = 0; y < tile.height; ++y) {
      std::copy_n(errors.row(y), tile.width,
                  map.errors.begin() + std::ptrdiff_t(tile.y + y) * test.width + tile.x);
    }
  }
  for (const float error : map.errors) {
    map.mean += error;
    map.max = std::max<double>(map.max, error);
  }
  map.mean /= static_cast<double>(map.errors.size());
  return map;
}

}  // namespace scenefile
