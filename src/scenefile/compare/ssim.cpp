#include "scenefile/compare/ssim.h"

#include "scenefile/compare/window.h"

namespace scenefile {

namespace {

constexpr int radius = 5;
constexpr double c1 = (0.01 * 255) * (0.01 * 255);
constexpr double c2 = (0.03 * 255) * (0.03 * 255);

// Centered on 0, so that squares keep enough precision in floats.
constexpr double middle = 128;

Plane luma(const Texture& picture) {
  Plane plane(picture.width, picture.height);
  for (std::size_t i = 0; i < plane.values.size(); ++i) {
    const std::uint8_t* p = picture.rgb.data() + 3 * i;
    plane.values[i] = static_cast<float>(0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2] - middle);
  }
  return plane;
}

Plane product(const Plane& a, const Plane& b) {
  Plane result(a.width, a.height);
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    result.values[i] = a.values[i] * b.values[i];
  }
  return result;
}

Plane blurred(const Plane& plane) {
  Taps taps = gaussian_taps(radius, 1.5);
  const double sum = sum_of(taps);
  for (double& tap : taps) {
    tap /= sum;
  }
  return filtered(plane, taps, taps);
}

struct Moments {
  Plane a, b, aa, bb, ab;

  double similarity(std::size_t i) const {
    const double ma = a.values[i];
    const double mb = b.values[i];
    const double va = aa.values[i] - ma * ma;
    const double vb = bb.values[i] - mb * mb;
    const double covariance = ab.values[i] - ma * mb;
    const double full_a = ma + middle;
    const double full_b = mb + middle;
    return (2 * full_a * full_b + c1) * (2 * covariance + c2) /
           ((full_a * full_a + full_b * full_b + c1) * (va + vb + c2));
  }
};

}  // namespace

double ssim(const Texture& first, const Texture& second) {
  if (first.width != second.width || first.height != second.height || first.empty()) {
    return first.empty() && second.empty() ? 1 : 0;
  }
  const Plane a = luma(first);
  const Plane b = luma(second);
  const Moments moments{blurred(a), blurred(b), blurred(product(a, a)), blurred(product(b, b)),
                        blurred(product(a, b))};
  const int left = a.width > 2 * radius ? radius : 0;
  const int top = a.height > 2 * radius ? radius : 0;
  double sum = 0;
  for (int y = top; y < a.height - top; ++y) {
    for (int x = left; x < a.width - left; ++x) {
      sum += moments.similarity(static_cast<std::size_t>(a.width) * y + x);
    }
  }
  return sum / (static_cast<double>(a.width - 2 * left) * (a.height - 2 * top));
}

}  // namespace scenefile
