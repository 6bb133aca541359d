#pragma once
// Tone mapping: linear pictures of any range as pictures in [0, 1].

#include "scenefile/asset/image.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace scenefile {

/// `course`: the extended curve of Reinhard et al. ("Photographic Tone Reproduction for Digital
/// Images", 2002, equation 4) on the luminance L, with the largest luminance of the picture as
/// white w: L (1 + L / w^2) / (1 + L); then values to the power 1/2 (gamma 2). `none`: unchanged.
enum class Tone : std::uint8_t { course, none };
inline constexpr std::array<std::string_view, 2> tone_words{"course", "none"};

/// Multiplies by 2^exposure, then applies the curve. Values above 1 can remain; encoders clamp.
Image tone_mapped(Image image, Tone tone, double exposure);

}  // namespace scenefile
