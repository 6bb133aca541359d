#include "scenefile/compare/measure.h"

#include "scenefile/compare/flip.h"
#include "scenefile/compare/ssim.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <utility>

namespace scenefile {

namespace {

// The value with as many digits as it takes to be on its side of the limit after rounding.
std::string text_beside(double value, double limit, int digits) {
  constexpr int most_digits = 17;
  std::string text = fmt::format("{:.{}f}", value, digits);
  const auto misleads = [&] {
    const double rounded = std::strtod(text.c_str(), nullptr);
    return value < limit ? rounded >= limit : rounded <= limit;
  };
  while (misleads() && digits < most_digits) {
    text = fmt::format("{:.{}f}", value, ++digits);
  }
  return text;
}

// The number of values that are equal in pictures of the same size.
std::size_t equal_values(const Texture& a, const Texture& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    count += a.rgb[i] == b.rgb[i] ? 1 : 0;
  }
  return count;
}

}  // namespace

PictureMeasures measure(const Texture& reference, const Texture& test, int threshold,
                        std::vector<float>* flip_errors) {
  PictureMeasures measures;
  measures.size = {test.width, test.height};
  measures.right_size = {reference.width, reference.height};
  measures.comparable = measures.same_size();
  measures.difference = compare_images(reference, test, threshold);
  FlipMap map;
  if (measures.difference.max == 0) {
    map.errors.assign(reference.rgb.size() / 3, 0);
  } else {
    map = flip(reference, test);
    measures.ssim = ssim(reference, test);
  }
  measures.flip_mean = map.mean;
  measures.flip_max = map.max;
  if (flip_errors != nullptr) {
    *flip_errors = std::move(map.errors);
  }
  return measures;
}

void round_alike(DecodedPicture& a, DecodedPicture& b) {
  if (a.is_linear() == b.is_linear()) {
    return;
  }
  DecodedPicture& linear = a.is_linear() ? a : b;
  const Texture& other = a.is_linear() ? b.texture : a.texture;
  Texture truncated = quantize(linear.linear, Rounding::truncate);
  if (truncated.width == other.width && truncated.height == other.height &&
      equal_values(truncated, other) > equal_values(linear.texture, other)) {
    linear.texture = std::move(truncated);
  }
}

std::vector<std::string> broken_thresholds(const Thresholds& thresholds,
                                           const PictureMeasures& measures) {
  std::vector<std::string> broken;
  const auto at_least = [&](const auto& least, double value, int digits, const char* words) {
    if (least && !(value >= *least)) {
      broken.push_back(
          fmt::format(fmt::runtime(words), text_beside(value, *least, digits), *least));
    }
  };
  const auto at_most = [&](const auto& most, double value, double scale, int digits,
                           const char* words) {
    if (most && !(value <= *most)) {
      broken.push_back(fmt::format(
          fmt::runtime(words), text_beside(scale * value, scale * *most, digits), scale * *most));
    }
  };
  if (!measures.comparable) {
    broken.push_back(fmt::format("the size is {}x{}, expected {}x{}", measures.size.x,
                                 measures.size.y, measures.right_size.x, measures.right_size.y));
    return broken;
  }
  if (thresholds == Thresholds{} && measures.difference.max > 0) {
    broken.emplace_back("the pictures are not equal");
  }
  at_least(thresholds.min_psnr_db, measures.difference.psnr_db, 2, "PSNR is {} dB, less than {:g}");
  at_most(thresholds.max_mean, measures.difference.mean, 1, 3,
          "the mean difference is {}/255, more than {:g}");
  at_most(thresholds.max_difference, measures.difference.max, 1, measures.linear ? 4 : 0,
          "the maximum difference is {}/255, more than {:g}");
  at_most(thresholds.max_share, measures.difference.share_over, 100, 3,
          "{} % of the pixels are off, more than {:g} %");
  at_least(thresholds.min_ssim, measures.ssim, 4, "SSIM is {}, less than {:g}");
  at_most(thresholds.max_flip, measures.flip_mean, 1, 4, "FLIP is {}, more than {:g}");
  return broken;
}

}  // namespace scenefile
