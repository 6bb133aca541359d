#pragma once
// Drawing with OpenGL instead of ray tracing, without a window.

#include "app/load.h"
#include "scenefile/asset/image.h"

#include <cstdint>
#include <memory>
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

/// Draws pictures of a scene. OpenGL is initialized and the scene is uploaded with the first
/// picture.
class GlPainter {
 public:
  /// Both must outlive this.
  GlPainter(const Options& options, LoadedScene& scene);
  ~GlPainter();
  GlPainter(const GlPainter&) = delete;
  GlPainter& operator=(const GlPainter&) = delete;

  /// Draws the scene with its current camera. Adds diagnostics, once, about what OpenGL leaves out.
  Outcome draw(Image& image, GlReport& report, Context& context);

 private:
  struct State;
  const Options& options_;
  LoadedScene& scene_;
  std::unique_ptr<State> state_;
};

}  // namespace scenefile::app
