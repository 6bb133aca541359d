#include "scenefile/asset/compare_images.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace scenefile {

ImageDifference compare_images(const Texture& a, const Texture& b, int threshold) {
  if (a.width != b.width || a.height != b.height || a.rgb.size() != b.rgb.size()) {
    return {0, 255, 255, 1};
  }
  std::uint64_t sum = 0;
  std::uint64_t squares = 0;
  std::uint64_t over = 0;
  int max = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    int worst = 0;
    for (std::size_t channel = i; channel < i + 3; ++channel) {
      const int difference = std::abs(int{a.rgb[channel]} - int{b.rgb[channel]});
      sum += static_cast<std::uint64_t>(difference);
      squares += static_cast<std::uint64_t>(difference * difference);
      worst = std::max(worst, difference);
    }
    max = std::max(max, worst);
    over += worst > threshold ? 1 : 0;
  }
  if (squares == 0) {
    return {};
  }
  const auto values = static_cast<double>(a.rgb.size());
  const double rms = std::sqrt(static_cast<double>(squares) / values);
  return {std::min(99.0, 20 * std::log10(255 / rms)), static_cast<double>(sum) / values,
          static_cast<double>(max), 3 * static_cast<double>(over) / values};
}

ImageDifference compare_images(const Image& a, const Image& b, int threshold) {
  if (a.width != b.width || a.height != b.height || a.rgb.size() != b.rgb.size()) {
    return {0, 255, 255, 1};
  }
  double sum = 0;
  double squares = 0;
  double max = 0;
  std::size_t over = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    double worst = 0;
    for (std::size_t channel = i; channel < i + 3; ++channel) {
      const double x = a.rgb[channel];
      const double y = b.rgb[channel];
      const bool same = x == y || (std::isnan(x) && std::isnan(y));
      const bool finite = std::isfinite(x) && std::isfinite(y);
      const double difference = same ? 0 : finite ? 255 * std::abs(x - y) : 255;
      sum += difference;
      squares += difference * difference;
      worst = std::max(worst, difference);
    }
    max = std::max(max, worst);
    over += worst > threshold ? 1 : 0;
  }
  if (max == 0) {
    return {};
  }
  const auto values = static_cast<double>(a.rgb.size());
  const double rms = std::sqrt(squares / values);  // 0 if all squares are too small for a double
  return {std::min(99.0, 20 * std::log10(255 / rms)), sum / values, max,
          3 * static_cast<double>(over) / values};
}

}  // namespace scenefile
