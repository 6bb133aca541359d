#pragma once
// All measures of how two pictures differ, and what a grader asks of them.

#include "scenefile/asset/compare_images.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace scenefile {

/// Smaller is alike for mean, max, share_over, flip_mean and flip_max; greater is alike for
/// psnr_db and ssim.
struct PictureMeasures {
  bool same_size = true;       ///< false: all others are those of pictures that differ everywhere
  glm::ivec2 size{0};          ///< of the picture that was tested
  glm::ivec2 right_size{0};    ///< of the reference
  ImageDifference difference;  ///< PSNR, mean, maximum, share of pixels over the threshold
  double ssim = 1;             ///< ssim.h
  double flip_mean = 0;        ///< flip.h
  double flip_max = 0;
};

/// `threshold`: a pixel counts in share_over when a channel is off by more, in 1/255. `flip_errors`
/// takes over the errors of the pixels, where given.
PictureMeasures measure(const Texture& reference, const Texture& test, int threshold = 8,
                        std::vector<float>* flip_errors = nullptr);

/// What a picture must keep to. With nothing set it must be equal to the reference.
struct Thresholds {
  std::optional<double> min_psnr_db{};
  std::optional<double> max_mean{};     ///< in 1/255
  std::optional<int> max_difference{};  ///< in 1/255
  std::optional<double> max_share{};    ///< of pixels over the threshold, in [0, 1]
  std::optional<double> min_ssim{};
  std::optional<double> max_flip{};  ///< mean FLIP

  friend bool operator==(const Thresholds&, const Thresholds&) = default;
};

/// What is not kept to, each as a clause such as "PSNR is 31.20 dB, less than 40". None: the
/// pictures are the same as far as anyone asked.
std::vector<std::string> broken_thresholds(const Thresholds& thresholds,
                                           const PictureMeasures& measures);

}  // namespace scenefile
