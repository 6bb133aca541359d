#pragma once
// The settings of the course's assignment Realtime, as plain data: docs/realtime.md.

#include "scenefile/base/shape.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace scenefile {

/// The two sliders of the assignment. Values are clamped to 1 to max_tessellation, and further to
/// the minimum of each shape: 2 rings for a sphere, 3 wedges for a round shape.
struct TessellationParameters {
  int parameter1 = 5;  ///< rings of a sphere or cap, stacks of a cylinder or cone, tiles of a cube
  int parameter2 = 5;  ///< wedges about the y axis; not used by cubes

  friend bool operator==(const TessellationParameters&, const TessellationParameters&) = default;
};

inline constexpr int max_tessellation = 1024;

/// The two halves of the assignment.
enum class Milestone : std::uint8_t {
  lights_camera,  ///< directional lights only; the picture is what the camera sees
  action          ///< also point lights and spotlights; resampled from a larger frame
};

/// Applied to the finished frame.
enum class Filter : std::uint8_t { none, invert, grayscale, blur, sharpen };

/// The words of options and of JSON output, by enumerator.
inline constexpr std::array<std::string_view, 2> milestone_words{"lights-camera", "action"};
inline constexpr std::array<std::string_view, 5> filter_words{"none", "invert", "grayscale", "blur",
                                                              "sharpen"};

constexpr std::string_view word_of(Milestone milestone) {
  return milestone_words[static_cast<std::size_t>(milestone)];
}
constexpr std::string_view word_of(Filter filter) {
  return filter_words[static_cast<std::size_t>(filter)];
}

/// The settings panel of the assignment's program.
struct RealtimeOptions {
  TessellationParameters tessellation;
  double near = 0.1;  ///< depth along the view axis; nearer surfaces are clipped. 0 < near < far
  double far = 100;   ///< depth along the view axis; farther surfaces are clipped
  Filter filter = Filter::none;
  Milestone milestone = Milestone::lights_camera;

  friend bool operator==(const RealtimeOptions&, const RealtimeOptions&) = default;
};

/// Whether the assignment has lights of the type; its program skips others.
constexpr bool has_light(Milestone milestone, LightType type) {
  switch (type) {
    case LightType::directional:
      return true;
    case LightType::point:
    case LightType::spot:
      return milestone == Milestone::action;
    case LightType::area:
      return false;
  }
  return false;
}

/// Size in pixels of the part of the window that the assignment's program draws in. Its screenshots
/// have a different size, so the size of the window matters twice: it determines the camera's
/// aspect ratio, and the size of Action's frame.
struct RealtimeWindow {
  int width = 0;
  int height = 0;
};

/// 1092 x 818 for a picture of 1024 x 768, proportional for others, at least 1 x 1. (Fitted to the
/// course's pictures, docs/realtime.md.)
constexpr RealtimeWindow realtime_window(int width, int height) {
  const auto scaled = [](std::int64_t side, std::int64_t window, std::int64_t picture) {
    const std::int64_t rounded = (2 * side * window + picture) / (2 * picture);
    return static_cast<int>(rounded < 1 ? 1 : rounded);
  };
  return {scaled(width, 1092, 1024), scaled(height, 818, 768)};
}

/// Size in pixels of the frame that is drawn and filtered, for a picture of that size. The scene
/// covers a viewport of the picture's size at its lower left; the rest is background.
constexpr RealtimeWindow realtime_frame(Milestone milestone, int width, int height) {
  switch (milestone) {
    case Milestone::lights_camera:
      break;
    case Milestone::action:
      return realtime_window(width, height);
  }
  return {width, height};
}

}  // namespace scenefile
