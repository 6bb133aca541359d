#pragma once
// The pictures that are compared: ours, the reference and mine.

#include "scenefile/asset/image_file.h"
#include "scenefile/compare/measure.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace scenefile::viewer {

/// Whose picture it is: the window's, the right one of somebody else's program, or that of the
/// program whose mistakes are looked for.
enum class Role : std::uint8_t { ours, reference, mine };
std::string_view role_word(Role role);

/// The two pictures that are compared. If both are the same, only ours is shown.
struct Sides {
  Role left = Role::ours;
  Role right = Role::ours;

  friend bool operator==(const Sides&, const Sides&) = default;
};

/// How two pictures are shown. In all but the last three, the left one is at its place.
enum class CompareView : std::uint8_t {
  off,           ///< only ours
  side_by_side,  ///< one above the other where that is larger
  split,         ///< left and right of a line
  flicker,       ///< by turns
  other,         ///< only the right one
  difference,    ///< heat map of the maximum channel difference
  flip,          ///< heat map of the visible difference
};
inline constexpr double flicker_seconds = 0.5;  ///< of each picture; slower than 3 flashes a second

/// A picture from a file.
struct OtherPicture {
  std::string path;
  std::shared_ptr<const DecodedPicture> decoded = nullptr;  ///< null: there is none
  std::uint64_t version = 0;                                ///< changes with `decoded`

  bool exists() const { return decoded != nullptr; }
};

struct Comparison {
  Sides sides;
  PictureMeasures measures;
  Texture difference;              ///< heat_map()
  Texture flip;                    ///< flip_picture()
  std::vector<float> flip_errors;  ///< of the pixels
};

/// Measured as by `scenefile diff`. Takes about a second per megapixel; call it on another thread.
Comparison compare_pictures(const Sides& sides, DecodedPicture left, DecodedPicture right);

/// "PSNR 34.21 dB   SSIM 0.9812   FLIP 0.0312   max 77/255   2.1 % of pixels off by more than 8".
std::string measures_text(const PictureMeasures& measures);

}  // namespace scenefile::viewer
