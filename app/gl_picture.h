#pragma once
// Drawing with OpenGL instead of tracing, without a window.

#include "app/load.h"
#include "scenefile/asset/image.h"

#include <cstdint>
#include <string>

namespace scenefile::app {

/// What OpenGL took.
struct GlReport {
  std::string renderer;  ///< in the driver's words; empty: OpenGL did not draw
  std::uint32_t draw_calls = 0;
  std::uint32_t shadow_maps = 0;
  std::uint64_t objects = 0;
  std::uint64_t triangles = 0;
  int samples = 0;  ///< of each pixel
};

/// Draws the scene; adds to its diagnostics what OpenGL leaves out.
Outcome draw_with_gl(const Options& options, LoadedScene& scene, Image& image, GlReport& report,
                     Context& context);

}  // namespace scenefile::app
