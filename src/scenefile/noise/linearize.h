#pragma once
// Linear values of pictures that were tone-mapped for the screen. Internal to noise.

#include "scenefile/asset/image_file.h"
#include "scenefile/trace/color.h"

#include <array>
#include <string>
#include <vector>

namespace scenefile {

/// How a program made 8-bit values. `course`: docs/path.md; `reinhard`: v / (1 + v) of each value,
/// then to the power 1 / 2.2; the others clamp to [0, 1] before the power or curve.
enum class ToneCurve : std::uint8_t { linear, course, reinhard, power22, srgb, power2, clamp };
inline constexpr std::array<std::string_view, 7> curve_words{
    "linear values",
    "the tone curve of the course",
    "the tone curve v / (1 + v) and gamma 2.2",
    "gamma 2.2",
    "sRGB",
    "gamma 2",
    "values from 0 to 1"};

/// Linear values. `usable`: false for pixels that are clipped or not finite.
struct LinearPicture {
  std::vector<Color> pixels;
  std::vector<Color> rounding;  ///< variances that 8 bits add; 0 for floats
  std::vector<char> usable;
};

/// Undoes the curve; of floats, too, if it is not `linear`. `white`: of the curve `course`, the
/// luminance that becomes 1.
LinearPicture linearized(const DecodedPicture& picture, ToneCurve curve, double white);

}  // namespace scenefile
