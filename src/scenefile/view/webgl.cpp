#include "scenefile/view/webgl.h"

#include "scenefile/view/gl_functions.h"

#include <GLES3/gl3.h>

#include <string_view>

namespace scenefile {

GlFunction find_webgl_function(const char* name) {
  const std::string_view wanted(name);
#define ROW(result, function, parameters)                 \
  if (wanted == "gl" #function) {                         \
    return reinterpret_cast<GlFunction>(&::gl##function); \
  }
  SCENEFILE_GL_FUNCTIONS(ROW)
#undef ROW
  return nullptr;
}

}  // namespace scenefile
