#pragma once
// The colors of the window. Internal to the files gui*.cpp.

#include <cstdint>

namespace scenefile::viewer {

/// Converts 0xrrggbb to Dear ImGui's packing: alpha, blue, green, red from the highest byte.
inline constexpr std::uint32_t rgba(unsigned rgb, unsigned alpha = 255) {
  return alpha << 24 | (rgb & 255U) << 16 | (rgb & 0xFF00U) | (rgb >> 16 & 255U);
}

inline constexpr unsigned color_panel = 0x202226;
inline constexpr unsigned color_field = 0x2b2e34;
inline constexpr unsigned color_line = 0x34383f;
inline constexpr unsigned color_text = 0xe2e4e8;
inline constexpr unsigned color_dim = 0x8d939e;
inline constexpr unsigned color_accent = 0xff9e3d;  ///< selection
inline constexpr unsigned color_link = 0xa8c7fa;
inline constexpr unsigned color_error = 0xff6b64;
inline constexpr unsigned color_warning = 0xf2c14e;
inline constexpr unsigned color_good = 0x7fc97f;
inline constexpr unsigned color_light = 0xffe08a;  ///< lights

}  // namespace scenefile::viewer
