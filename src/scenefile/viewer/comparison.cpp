#include "scenefile/viewer/comparison.h"

#include "scenefile/compare/sheet.h"

#include <fmt/format.h>

#include <array>

namespace scenefile::viewer {

std::string_view role_word(Role role) {
  static constexpr std::array<std::string_view, 3> words{"ours", "reference", "mine"};
  return words[static_cast<std::size_t>(role)];
}

Comparison compare_pictures(const Sides& sides, DecodedPicture left, DecodedPicture right) {
  Comparison comparison;
  comparison.sides = sides;
  round_alike(left, right);
  // As diff: the reference comes first.
  const bool exchanged = sides.right == Role::reference;
  const Texture& reference = exchanged ? right.texture : left.texture;
  const Texture& other = exchanged ? left.texture : right.texture;
  comparison.measures = measure(reference, other, 8, &comparison.flip_errors);
  if (left.is_linear() && right.is_linear()) {
    comparison.measures.difference = compare_images(left.linear, right.linear);
    comparison.measures.linear = true;
  }
  comparison.difference = heat_map(reference, other);
  comparison.flip = flip_picture(comparison.flip_errors, reference.width, reference.height);
  return comparison;
}

std::string measures_text(const PictureMeasures& measures) {
  const ImageDifference& d = measures.difference;
  return fmt::format(
      "PSNR {:.2f} dB   SSIM {:.4f}   FLIP {:.4f}   max {}/255   {:.2f} % off by more than 8",
      d.psnr_db, measures.ssim, measures.flip_mean, d.max, 100 * d.share_over);
}

}  // namespace scenefile::viewer
