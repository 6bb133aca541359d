#pragma once
// The course's assignment Realtime: docs/realtime.md.

#include "scenefile/geometry/realtime_mesh.h"

#include <cstdint>

namespace scenefile {

/// The two halves of the assignment.
enum class Milestone : std::uint8_t {
  lights_camera,  ///< directional lights only; the picture is what the camera sees
  action          ///< also point lights and spotlights; resampled from a larger frame
};

/// Applied to the finished frame.
enum class Filter : std::uint8_t { none, invert, grayscale, blur, sharpen };

/// The settings panel of the assignment's program.
struct RealtimeOptions {
  TessellationParameters tessellation;
  double near = 0.1;  ///< depth along the view axis; nearer surfaces are clipped. 0 < near < far
  double far = 100;   ///< depth along the view axis; farther surfaces are clipped
  Filter filter = Filter::none;
  Milestone milestone = Milestone::lights_camera;

  friend bool operator==(const RealtimeOptions&, const RealtimeOptions&) = default;
};

/// Size in pixels of the part of the window that the assignment's program draws in. Its screenshots
/// have a different size, so the size of the window matters twice: it determines the camera's
/// aspect ratio, and the size of Action's frame.
struct RealtimeWindow {
  int width = 0;
  int height = 0;
};

/// 1092 x 818 for a picture of 1024 x 768, proportional for others. (Fitted to the course's
/// pictures, docs/realtime.md.)
RealtimeWindow realtime_window(int width, int height);

}  // namespace scenefile
