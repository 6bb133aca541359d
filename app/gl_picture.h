#pragma once
// Draws with OpenGL instead of tracing, without a window.

#include "app/load.h"
#include "scenefile/asset/image.h"

#include <cstdint>
#include <string>

namespace scenefile::app {

/// Statistics of drawing with OpenGL.
struct GlReport {
  std::string renderer;  ///< the driver's name; empty: OpenGL did not draw
  std::uint32_t draw_calls = 0;
  std::uint32_t shadow_maps = 0;
  std::uint64_t objects = 0;
  std::uint64_t triangles = 0;
  int samples = 0;  ///< per pixel
};

/// Draws the scene; adds what OpenGL leaves out to its diagnostics.
Outcome draw_with_gl(const Options& options, LoadedScene& scene, Image& image, GlReport& report,
                     Context& context);

}  // namespace scenefile::app
