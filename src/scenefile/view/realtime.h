#pragma once
// What the course's assignment Realtime draws, and how it is asked for: docs/realtime.md.

#include "scenefile/geometry/realtime_mesh.h"

#include <cstdint>

namespace scenefile {

/// The two halves of the assignment.
enum class Milestone : std::uint8_t {
  lights_camera,  ///< directional lights only; the picture is what the camera sees
  action          ///< point lights and spotlights too; the picture is resampled from a larger frame
};

/// What is done to the finished frame.
enum class Filter : std::uint8_t { none, invert, grayscale, blur, sharpen };

/// The panel of the assignment's program.
struct RealtimeOptions {
  TessellationParameters tessellation;
  double near = 0.1;  ///< depth along the view; nearer surfaces are clipped. 0 < near < far
  double far = 100;   ///< depth along the view; farther surfaces are clipped
  Filter filter = Filter::none;
  Milestone milestone = Milestone::lights_camera;

  friend bool operator==(const RealtimeOptions&, const RealtimeOptions&) = default;
};

/// Size in pixels of the part of the window that the assignment's program draws in. Its screenshots
/// have another size, and the window's is seen in two places: the camera keeps the aspect ratio of
/// the window, and Action draws on a frame of its size.
struct RealtimeWindow {
  int width = 0;
  int height = 0;
};

/// 1092 x 818 for a picture of 1024 x 768, in proportion for others. (Fitted against the course's
/// pictures, docs/realtime.md.)
RealtimeWindow realtime_window(int width, int height);

}  // namespace scenefile
