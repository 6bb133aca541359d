// Replaces gl_picture.cpp if the program is built without the room view.

#include "app/gl_picture.h"

namespace scenefile::app {

Outcome draw_with_gl(const Options& /*options*/, LoadedScene& /*scene*/, Image& /*image*/,
                     GlReport& /*report*/, Context& /*context*/) {
  return {ExitCode::environment,
          "--engine gl: this program was built without OpenGL (SCENEFILE_VIEW)"};
}

}  // namespace scenefile::app
