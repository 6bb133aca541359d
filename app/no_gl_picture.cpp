// Replaces gl_picture.cpp if the program is built without src/scenefile/view.

#include "app/gl_picture.h"

namespace scenefile::app {

struct GlPainter::State {};

GlPainter::GlPainter(const Options& options, LoadedScene& scene)
    : options_(options), scene_(scene) {}

GlPainter::~GlPainter() = default;

Outcome GlPainter::draw(Image& /*image*/, GlReport& /*report*/, Context& /*context*/) {
  return {ExitCode::environment,
          "--engine gl: this program was built without OpenGL (SCENEFILE_VIEW)"};
}

}  // namespace scenefile::app
