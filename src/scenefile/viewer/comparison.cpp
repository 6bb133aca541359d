#include "scenefile/viewer/comparison.h"

#include "scenefile/compare/sheet.h"

#include <fmt/format.h>

#include <vector>

namespace scenefile::viewer {

Comparison compare_pictures(const Texture& reference, const Texture& ours) {
  Comparison comparison;
  std::vector<float> errors;
  comparison.measures = measure(reference, ours, 8, &errors);
  comparison.difference = heat_map(reference, ours);
  comparison.flip = flip_picture(errors, reference.width, reference.height);
  return comparison;
}

std::string measures_text(const PictureMeasures& measures) {
  if (!measures.same_size) {
    return fmt::format("{}x{}, and the reference {}x{}", measures.size.x, measures.size.y,
                       measures.right_size.x, measures.right_size.y);
  }
  const ImageDifference& d = measures.difference;
  return fmt::format(
      "PSNR {:.2f} dB   SSIM {:.4f}   FLIP {:.4f}   max {}/255   {:.2f} % off by more than 8",
      d.psnr_db, measures.ssim, measures.flip_mean, d.max, 100 * d.share_over);
}

}  // namespace scenefile::viewer
