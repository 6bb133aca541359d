#include "scenefile/compare/ssim.h"

#include "scenefile/compare/window.h"

#include <algorithm>

namespace scenefile {

namespace {

constexpr int radius = 5;
// Values are centered on 0, so that squares keep enough precision in floats.
constexpr SsimConstants constants{(0.01F * 255) * (0.01F * 255), (0.03F * 255) * (0.03F * 255),
                                  128};

// A plane, and its weighted mean around each pixel of a row.
struct Blurred {
  PaddedRow input;
  FilteredRows rows;
  std::vector<float> means;

  Blurred(int width, int height, const Taps& taps)
      : input(width, radius), rows(width, height, radius, taps), means(width) {}

  void take(int y, const std::vector<Span>& spans) {
    input.repeat_edges();
    rows.take(y, input, spans);
  }
  void find_means(int y, const Taps& taps, const std::vector<Span>& spans) {
    WeightedRows around;
    rows.add_around(y, taps, around);
    for (const Span& span : spans) {
      around.add_up(span, means.data());
    }
  }
};

// The planes of MeanRow, of the pictures' luma.
struct Planes {
  Blurred s, d, ss, dd;

  void set(const Texture& first, const Texture& second, int y) {
    const std::uint8_t* a = first.texel(0, y);
    const std::uint8_t* b = second.texel(0, y);
    const auto luma = [](int red, int green, int blue) {
      return 0.299F * static_cast<float>(red) + 0.587F * static_cast<float>(green) +
             0.114F * static_cast<float>(blue);
    };
    for (int x = 0; x < first.width; ++x, a += 3, b += 3) {
      const float mean = luma(a[0] + b[0], a[1] + b[1], a[2] + b[2]) / 2 - constants.middle;
      const float difference = luma(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
      s.input.pixels()[x] = mean;
      d.input.pixels()[x] = difference;
      ss.input.pixels()[x] = mean * mean;
      dd.input.pixels()[x] = difference * difference;
    }
  }
};

}  // namespace

double ssim(const Texture& a, const Texture& b) {
  if (a.width != b.width || a.height != b.height || a.empty()) {
    return a.empty() && b.empty() ? 1 : 0;
  }
  const NearDifferences near(a, b, radius, radius);
  const NearDifferences needed = near.grown_down(radius);
  Taps taps = gaussian_taps(radius, 1.5);
  taps = scaled_taps(taps, 1 / sum_of(taps));
  const Blurred none(a.width, a.height, taps);
  Planes planes{none, none, none, none};
  const std::array<Blurred*, 4> all{&planes.s, &planes.d, &planes.ss, &planes.dd};
  std::vector<float> row(a.width);
  const int left = a.width > 2 * radius ? radius : 0;
  const int top = a.height > 2 * radius ? radius : 0;
  double sum = 0;  // of 1 - SSIM; where the pictures are equal, it is 0
  for (int taken = 0; taken < a.height + radius; ++taken) {
    if (taken < a.height) {
      if (const std::vector<Span> spans = needed.spans(taken); !spans.empty()) {
        planes.set(a, b, taken);
        for (Blurred* plane : all) {
          plane->take(taken, spans);
        }
      }
    }
    const int y = taken - radius;
    if (y < top || y >= a.height - top) {
      continue;
    }
    const std::vector<Span> spans = near.spans(y);
    for (Blurred* plane : all) {
      plane->find_means(y, taps, spans);
    }
    for (const Span& span : spans) {
      dissimilarities(constants,
                      {planes.s.means.data(), planes.d.means.data(), planes.ss.means.data(),
                       planes.dd.means.data()},
                      span, row.data());
      for (int x = std::max(span.begin, left); x < std::min(span.end, a.width - left); ++x) {
        sum += row[x];
      }
    }
  }
  return 1 - sum / (static_cast<double>(a.width - 2 * left) * (a.height - 2 * top));
}

}  // namespace scenefile
