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

// Exponent and knee of the color error (sections 4.1.4 and 4.2.2 of the paper).
constexpr double color_exponent = 0.7;
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

// Rows are those of a matrix whose columns glm stores.
ColorMatrix by_rows(const glm::dmat3& m) {
  ColorMatrix result{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      result[row][column] = static_cast<float>(m[column][row]);
    }
  }
  return result;
}

// From linear sRGB to XYZ relative to white, and back.
struct ColorSpaces {
  ColorMatrix xyz;
  ColorMatrix rgb;

  ColorSpaces() {
    glm::dmat3 m = matrix_to_xyz();
    const glm::dvec3 white = m * glm::dvec3(1);
    for (int column = 0; column < 3; ++column) {
      m[column] /= white;
    }
    xyz = by_rows(m);
    rgb = by_rows(glm::inverse(m));
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
  int reach = 0;  // of the widest, in pixels

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

// One of the pictures, row by row: what FLIP compares.
class SeenPicture {
 public:
  SeenPicture(const Texture& picture, const Filters& filters)
      : picture_(picture),
        filters_(filters),
        input_(3, PaddedRow(picture.width, filters.reach)),
        smooth_(rows_of(filters.smooth)),
        edge_(rows_of(filters.edge)),
        point_(rows_of(filters.point)),
        outputs_(6, std::vector<float>(picture.width)) {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      for (const Filter& filter : filters.channels[i]) {
        channels_[i].push_back(rows_of(filter.across));
      }
    }
    for (std::size_t i = 0; i < linear_.size(); ++i) {
      linear_[i] = static_cast<float>(linear_from_srgb(static_cast<double>(i) / 255));
    }
  }

  void take(const ColorSpaces& spaces, int y, const std::vector<Span>& spans) {
    const Rows3 rows{input_[0].pixels(), input_[1].pixels(), input_[2].pixels()};
    const std::uint8_t* p = picture_.texel(0, y);
    for (int x = 0; x < picture_.width; ++x, p += 3) {
      for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i][x] = linear_[p[i]];
      }
    }
    rgb_to_ycxcz(spaces.xyz, {0, picture_.width}, rows);
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      input_[i].repeat_edges();
      for (FilteredRows& filtered : channels_[i]) {
        filtered.take(y, input_[i], spans);
      }
    }
    for (FilteredRows* filtered : {&smooth_, &edge_, &point_}) {
      filtered->take(y, input_[0], spans);
    }
  }

  // Row y, when all rows that the filters need are taken.
  FlipRow row(const ColorSpaces& spaces, int y, const std::vector<Span>& spans) {
    const Rows3 lab{outputs_[0].data(), outputs_[1].data(), outputs_[2].data()};
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      WeightedRows sum;
      for (std::size_t k = 0; k < channels_[i].size(); ++k) {
        channels_[i][k].add_around(y, filters_.channels[i][k].down, sum);
      }
      add_up(sum, spans, lab[i]);
    }
    for (const Span& span : spans) {
      ycxcz_to_hunt_lab(spaces.xyz, spaces.rgb, span, lab);
    }
    detect(y, edge_, filters_.edge, spans, outputs_[3].data());
    detect(y, point_, filters_.point, spans, outputs_[4].data());
    return {lab, outputs_[3].data(), outputs_[4].data()};
  }

 private:
  FilteredRows rows_of(const Taps& across) const {
    return {picture_.width, picture_.height, filters_.reach, across};
  }

  static void add_up(const WeightedRows& rows, const std::vector<Span>& spans, float* to) {
    for (const Span& span : spans) {
      rows.add_up(span, to);
    }
  }

  // The length of the gradient at each pixel, by the same filter in both directions.
  void detect(int y, const FilteredRows& derivative, const Taps& derivative_taps,
              const std::vector<Span>& spans, float* to) {
    WeightedRows across;
    derivative.add_around(y, filters_.smooth, across);
    WeightedRows down;
    smooth_.add_around(y, derivative_taps, down);
    float* const other = outputs_[5].data();
    for (const Span& span : spans) {
      across.add_up(span, to);
      down.add_up(span, other);
      lengths(span, to, other);
    }
  }

  const Texture& picture_;
  const Filters& filters_;
  std::vector<PaddedRow> input_;                       // in YCxCz
  std::array<std::vector<FilteredRows>, 3> channels_;  // of YCxCz
  FilteredRows smooth_, edge_, point_;                 // of Y
  std::vector<std::vector<float>> outputs_;
  std::array<float, 256> linear_{};
};

// Maps color errors to [0, 1]; the largest is that between green and blue.
ColorErrorCurve error_curve(const ColorSpaces& spaces) {
  std::array<float, 2> r{0, 0};
  std::array<float, 2> g{1, 0};
  std::array<float, 2> b{0, 1};
  const Rows3 colors{r.data(), g.data(), b.data()};
  rgb_to_ycxcz(spaces.xyz, {0, 2}, colors);
  ycxcz_to_hunt_lab(spaces.xyz, spaces.rgb, {0, 2}, colors);
  const double hyab = std::abs(r[0] - r[1]) + std::hypot(g[0] - g[1], b[0] - b[1]);
  const double largest = std::pow(hyab, color_exponent);
  return {static_cast<float>(color_exponent), static_cast<float>(knee * largest),
          static_cast<float>(knee_value), static_cast<float>(largest)};
}

}  // namespace

FlipMap flip(const Texture& reference, const Texture& test, double pixels_per_degree) {
  FlipMap map;
  if (reference.width != test.width || reference.height != test.height || reference.empty()) {
    map.mean = map.max = reference.empty() && test.empty() ? 0 : 1;
    return map;
  }
  const int width = test.width;
  const int height = test.height;
  const ColorSpaces spaces;
  const ColorErrorCurve curve = error_curve(spaces);
  const Filters filters(pixels_per_degree);
  const NearDifferences near(reference, test, filters.reach, filters.reach);
  const NearDifferences needed = near.grown_down(filters.reach);
  SeenPicture a(reference, filters);
  SeenPicture b(test, filters);
  map.errors.resize(static_cast<std::size_t>(width) * height);
  for (int taken = 0; taken < height + filters.reach; ++taken) {
    if (taken < height) {
      if (const std::vector<Span> spans = needed.spans(taken); !spans.empty()) {
        a.take(spaces, taken, spans);
        b.take(spaces, taken, spans);
      }
    }
    const int y = taken - filters.reach;
    const std::vector<Span> spans = y >= 0 ? near.spans(y) : std::vector<Span>();
    if (spans.empty()) {
      continue;
    }
    const FlipRow row_a = a.row(spaces, y, spans);
    const FlipRow row_b = b.row(spaces, y, spans);
    float* const errors = map.errors.data() + static_cast<std::size_t>(y) * width;
    for (const Span& span : spans) {
      flip_errors(curve, row_a, row_b, span, errors);
      for (int x = span.begin; x < span.end; ++x) {
        map.mean += errors[x];
        map.max = std::max<double>(map.max, errors[x]);
      }
    }
  }
  map.mean /= static_cast<double>(map.errors.size());
  return map;
}

}  // namespace scenefile
