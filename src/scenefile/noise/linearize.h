#pragma once
// Linear values of pictures that were tone-mapped for the screen. Internal to noise.

#include "scenefile/asset/image_file.h"
#include "scenefile/trace/color.h"

#include <string>
#include <vector>

namespace scenefile {

/// How a program made 8-bit values. `course`: docs/path.md; `compressed`: the same without gamma;
/// `reinhard`: v / (1 + v) of each value, `luminance`: v / (1 + L), and `film`: 1 - exp(-v), then a
/// gamma; the others clamp to [0, 1] before the power or curve.
enum class ToneCurve : std::uint8_t {
  linear,
  course,
  compressed,
  reinhard,
  luminance,
  film,
  power,
  srgb,
  clamp
};

/// ScreenCurve::parameter of `reinhard`, `luminance` and `film` for sRGB instead of a power.
inline constexpr double srgb_gamma = 0;

/// A curve and its parameter: of `course` and `compressed` the luminance that becomes 1, of
/// `reinhard`, `luminance`, `film` and `power` the exponent.
struct ScreenCurve {
  ToneCurve curve = ToneCurve::linear;
  double parameter = 1;

  std::string words() const;
  /// Whether values above 1 are clamped instead of compressed.
  bool clamps() const;
  /// The value for the screen of such a curve before it is clamped.
  double unclamped(double value) const;
};

/// Linear values. `usable`: false for pixels that are clipped or not finite.
struct LinearPicture {
  std::vector<Color> pixels;
  std::vector<Color> rounding;  ///< variances that 8 bits add; 0 for floats
  std::vector<char> usable;
};

/// Undoes the curve; of floats, too, if it is not `linear`.
LinearPicture linearized(const DecodedPicture& picture, const ScreenCurve& screen);

}  // namespace scenefile
