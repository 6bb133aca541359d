#pragma once
// Tone mapping: linear pictures of any range as pictures in [0, 1].

#include "scenefile/asset/image.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace scenefile {

/// `course`: the extended curve of Reinhard et al. ("Photographic Tone Reproduction for Digital
/// Images", 2002, equation 4) on the luminance L, with the largest luminance of the picture as
/// white w: L (1 + L / w^2) / (1 + L); then values to the power 1/2 (gamma 2). `none`: unchanged.
enum class Tone : std::uint8_t { course, none };
inline constexpr std::array<std::string_view, 2> tone_words{"course", "none"};

/// The largest luminance of pixels (red, green and blue each) times 2^exposure: the white of a
/// picture, if they are all of its pixels.
double brightest(std::span<const float> rgb, double exposure);

/// What the curve `course` makes of gray with this luminance.
double course_tone(double bright, double white);

/// Multiplies by 2^exposure, then applies the curve with this white. Values above 1 can remain;
/// encoders clamp.
void map_tones(std::span<float> rgb, Tone tone, double exposure, double white);
/// The same for a whole picture.
Image tone_mapped(Image image, Tone tone, double exposure);

}  // namespace scenefile
