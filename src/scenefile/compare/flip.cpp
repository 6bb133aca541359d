#include "scenefile/compare/flip.h"

#include "scenefile/compare/window.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace scenefile {

namespace {

using std::numbers::pi;

// Exponents and knees of the paper's sections 4.1.4, 4.2.2 and 4.3.
constexpr double color_exponent = 0.7;
constexpr double feature_exponent = 0.5;
constexpr double knee = 0.4;             // share of the largest color error ...
constexpr double knee_value = 0.95;      // ... that is mapped to this
constexpr double feature_width = 0.082;  // degrees

// Rows of the matrix from linear sRGB to CIE XYZ (D65).
constexpr std::array<std::array<double, 3>, 3> xyz_rows{
    {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
     {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
     {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

glm::dmat3 matrix_to_xyz() {
  glm::dmat3 m;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      m[column][row] = xyz_rows[row][column];
    }
  }
  return m;
}

const glm::dmat3 xyz_from_rgb = matrix_to_xyz();
const glm::dmat3 rgb_from_xyz = glm::inverse(xyz_from_rgb);
const glm::dvec3 white = xyz_from_rgb * glm::dvec3(1);

double linear_from_srgb(double value) {
  return value > 0.04045 ? std::pow((value + 0.055) / 1.055, 2.4) : value / 12.92;
}

// An opponent color space for which the eye's contrast sensitivity is known.
glm::dvec3 ycxcz_from_rgb(const glm::dvec3& rgb) {
  const glm::dvec3 n = xyz_from_rgb * rgb / white;
  return {116 * n.y - 16, 500 * (n.x - n.y), 200 * (n.y - n.z)};
}

glm::dvec3 rgb_from_ycxcz(const glm::dvec3& color) {
  const double y = (color.x + 16) / 116;
  return rgb_from_xyz * (white * glm::dvec3(y + color.y / 500, y, y - color.z / 200));
}

double lab_curve(double t) {
  constexpr double delta = 6.0 / 29;
  return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

// CIELAB with chroma that fades with lightness (Hunt effect).
glm::dvec3 hunt_lab(const glm::dvec3& rgb) {
  const glm::dvec3 n = xyz_from_rgb * rgb / white;
  const glm::dvec3 f(lab_curve(n.x), lab_curve(n.y), lab_curve(n.z));
  const double lightness = 116 * f.y - 16;
  const double fading = 0.01 * lightness;
  return {lightness, fading * 500 * (f.x - f.y), fading * 200 * (f.y - f.z)};
}

double hyab(const glm::dvec3& a, const glm::dvec3& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

struct Opponent {
  Plane y, cx, cz;

  Opponent(int width, int height) : y(width, height), cx(y), cz(y) {}
};

Opponent opponent(const Texture& picture) {
  std::array<double, 256> linear{};
  for (int i = 0; i < 256; ++i) {
    linear[i] = linear_from_srgb(i / 255.0);
  }
  Opponent result(picture.width, picture.height);
  for (std::size_t i = 0; i < result.y.values.size(); ++i) {
    const std::uint8_t* p = picture.rgb.data() + 3 * i;
    const glm::dvec3 color = ycxcz_from_rgb({linear[p[0]], linear[p[1]], linear[p[2]]});
    result.y.values[i] = static_cast<float>(color.x);
    result.cx.values[i] = static_cast<float>(color.y);
    result.cz.values[i] = static_cast<float>(color.z);
  }
  return result;
}

// A Gaussian of the contrast sensitivity functions: a sqrt(pi / b) exp(-(pi x)^2 / b), with x in
// degrees.
struct Sensitivity {
  double a = 1;
  double b = 1;
};

// A channel as seen from this distance: filtered with a normalized sum of Gaussians.
Plane seen(const Plane& channel, const std::vector<Sensitivity>& sum, double pixels_per_degree) {
  constexpr double widest = 0.04;
  const double reach = 3 * std::sqrt(widest / (2 * pi * pi)) * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(reach));
  double total = 0;
  Plane result(channel.width, channel.height);
  for (const Sensitivity& s : sum) {
    const Taps taps = gaussian_taps(radius, std::sqrt(s.b / 2) / pi * pixels_per_degree);
    const double weight = s.a * std::sqrt(pi / s.b);
    total += weight * sum_of(taps) * sum_of(taps);
    const Plane part = filtered(channel, taps, taps);
    for (std::size_t i = 0; i < part.values.size(); ++i) {
      result.values[i] += static_cast<float>(weight * part.values[i]);
    }
  }
  for (float& value : result.values) {
    value = static_cast<float>(value / total);
  }
  return result;
}

Opponent seen(const Opponent& picture, double pixels_per_degree) {
  Opponent result(picture);
  result.y = seen(picture.y, {{1, 0.0047}}, pixels_per_degree);
  result.cx = seen(picture.cx, {{1, 0.0053}}, pixels_per_degree);
  result.cz = seen(picture.cz, {{34.1, 0.04}, {13.5, 0.025}}, pixels_per_degree);
  return result;
}

glm::dvec3 lab_at(const Opponent& picture, std::size_t i) {
  const glm::dvec3 color(picture.y.values[i], picture.cx.values[i], picture.cz.values[i]);
  return hunt_lab(glm::clamp(rgb_from_ycxcz(color), glm::dvec3(0), glm::dvec3(1)));
}

// The color error, mapped to [0, 1].
double color_error(const glm::dvec3& a, const glm::dvec3& b) {
  static const double largest =
      std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), color_exponent);
  const double error = std::pow(hyab(a, b), color_exponent);
  const double bend = knee * largest;
  return error < bend ? knee_value / bend * error
                      : knee_value + (error - bend) / (largest - bend) * (1 - knee_value);
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

// The length of the gradient at each pixel, by the same filter in both directions.
Plane detected(const Plane& light, const Taps& derivative, const Taps& smooth) {
  Plane result = filtered(light, derivative, smooth);
  const Plane down = filtered(light, smooth, derivative);
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    result.values[i] = std::hypot(result.values[i], down.values[i]);
  }
  return result;
}

struct Features {
  Plane edges, points;
};

Features features(const Plane& y, double pixels_per_degree) {
  const double sigma = 0.5 * feature_width * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  Taps smooth = gaussian_taps(radius, sigma);
  Taps edge = smooth;
  Taps point = smooth;
  const double sum = sum_of(smooth);
  for (int x = -radius; x <= radius; ++x) {
    edge[x + radius] *= -x;
    point[x + radius] *= x * x / (sigma * sigma) - 1;
    smooth[x + radius] /= sum;
  }
  Plane light(y.width, y.height);
  std::transform(y.values.begin(), y.values.end(), light.values.begin(),
                 [](float value) { return (value + 16) / 116; });
  return {detected(light, balanced(edge), smooth), detected(light, balanced(point), smooth)};
}

double feature_error(const Features& a, const Features& b, std::size_t i) {
  const double edges = std::abs(double(a.edges.values[i]) - b.edges.values[i]);
  const double points = std::abs(double(a.points.values[i]) - b.points.values[i]);
  return std::pow(std::max(edges, points) / std::sqrt(2.0), feature_exponent);
}

}  // namespace

FlipMap flip(const Texture& reference, const Texture& test, double pixels_per_degree) {
  FlipMap map;
  if (reference.width != test.width || reference.height != test.height || reference.empty()) {
    map.mean = map.max = reference.empty() && test.empty() ? 0 : 1;
    return map;
  }
  const Opponent a = opponent(reference);
  const Opponent b = opponent(test);
  const Features features_a = features(a.y, pixels_per_degree);
  const Features features_b = features(b.y, pixels_per_degree);
  const Opponent seen_a = seen(a, pixels_per_degree);
  const Opponent seen_b = seen(b, pixels_per_degree);
  map.errors.resize(a.y.values.size());
  for (std::size_t i = 0; i < map.errors.size(); ++i) {
    const double color = color_error(lab_at(seen_a, i), lab_at(seen_b, i));
    const double error = std::pow(color, 1 - feature_error(features_a, features_b, i));
    map.errors[i] = static_cast<float>(std::clamp(error, 0.0, 1.0));
    map.mean += map.errors[i];
    map.max = std::max<double>(map.max, map.errors[i]);
  }
  map.mean /= static_cast<double>(map.errors.size());
  return map;
}

}  // namespace scenefile
