#include "scenefile/compare/measure.h"

#include "scenefile/compare/flip.h"
#include "scenefile/compare/ssim.h"

#include <fmt/format.h>

namespace scenefile {

PictureMeasures measure(const Texture& reference, const Texture& test, int threshold,
                        std::vector<float>* flip_errors) {
  PictureMeasures measures;
  measures.size = {test.width, test.height};
  measures.right_size = {reference.width, reference.height};
  measures.same_size = measures.size == measures.right_size;
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

std::vector<std::string> broken_thresholds(const Thresholds& thresholds,
                                           const PictureMeasures& measures) {
  std::vector<std::string> broken;
  const auto at_least = [&](const auto& least, double value, const char* words) {
    if (least && !(value >= *least)) {
      broken.push_back(fmt::format(fmt::runtime(words), value, *least));
    }
  };
  const auto at_most = [&](const auto& most, double value, double scale, const char* words) {
    if (most && !(value <= *most)) {
      broken.push_back(fmt::format(fmt::runtime(words), scale * value, scale * *most));
    }
  };
  if (!measures.same_size) {
    broken.push_back(fmt::format("the size is {}x{}, expected {}x{}", measures.size.x,
                                 measures.size.y, measures.right_size.x, measures.right_size.y));
    return broken;
  }
  if (thresholds == Thresholds{} && measures.difference.max > 0) {
    broken.emplace_back("the pictures are not equal");
  }
  at_least(thresholds.min_psnr_db, measures.difference.psnr_db,
           "PSNR is {:.2f} dB, less than {:g}");
  at_most(thresholds.max_mean, measures.difference.mean, 1,
          "the mean difference is {:.3f}/255, more than {:g}");
  at_most(thresholds.max_difference, measures.difference.max, 1,
          "the maximum difference is {:g}/255, more than {:g}");
  at_most(thresholds.max_share, measures.difference.share_over, 100,
          "{:.3f} % of the pixels are off, more than {:g} %");
  at_least(thresholds.min_ssim, measures.ssim, "SSIM is {:.4f}, less than {:g}");
  at_most(thresholds.max_flip, measures.flip_mean, 1, "FLIP is {:.4f}, more than {:g}");
  return broken;
}

}  // namespace scenefile
