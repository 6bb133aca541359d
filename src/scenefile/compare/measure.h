#pragma once
// All measures of the difference between two pictures, and thresholds for them.

#include "scenefile/asset/compare_images.h"
#include "scenefile/asset/image_file.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <vector>

namespace scenefile {

/// For mean, max, share_over, flip_mean and flip_max, smaller is more alike; for psnr_db and ssim,
/// larger is more alike.
struct PictureMeasures {
  bool comparable = true;      ///< false: all measures have their worst value
  glm::ivec2 size{0};          ///< of the picture under test
  glm::ivec2 right_size{0};    ///< of the reference
  ImageDifference difference;  ///< PSNR, mean, maximum, share of pixels over the threshold
  bool linear = false;         ///< whether `difference` is of floats; the rest is of 8-bit values
  double ssim = 1;             ///< see ssim.h
  double flip_mean = 0;        ///< see flip.h
  double flip_max = 0;

  /// False, but comparable: the measures are of pictures that were brought to one size.
  bool same_size() const { return size == right_size; }
};

/// Computes all measures. `threshold`, in 1/255: a pixel counts in share_over if a channel differs
/// by more. `flip_errors`, if not null, receives the error of each pixel.
PictureMeasures measure(const Texture& reference, const Texture& test, int threshold = 8,
                        std::vector<float>* flip_errors = nullptr);

/// If one picture has floats and the other 8-bit values, the floats become 8-bit values, too:
/// clamped to [0, 1], and rounded or truncated, whichever gives more of the other's values.
void round_alike(DecodedPicture& a, DecodedPicture& b);

/// Limits that a picture must meet. If none is set, it must equal the reference.
struct Thresholds {
  std::optional<double> min_psnr_db{};
  std::optional<double> max_mean{};        ///< in 1/255
  std::optional<double> max_difference{};  ///< in 1/255
  std::optional<double> max_share{};       ///< of pixels over the threshold, in [0, 1]
  std::optional<double> min_ssim{};
  std::optional<double> max_flip{};  ///< mean FLIP

  friend bool operator==(const Thresholds&, const Thresholds&) = default;
};

/// The thresholds that are not met, each as a clause such as "PSNR is 31.20 dB, less than 40".
/// Empty if all are met.
std::vector<std::string> broken_thresholds(const Thresholds& thresholds,
                                           const PictureMeasures& measures);

}  // namespace scenefile
