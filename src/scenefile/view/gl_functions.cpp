#include "scenefile/view/gl_functions.h"

namespace scenefile::gl {

std::string load(GetProcAddress find, Functions& functions) {
#define ROW(result, name, parameters)                                            \
  functions.name = reinterpret_cast<decltype(functions.name)>(find("gl" #name)); \
  if (functions.name == nullptr) {                                               \
    return "gl" #name;                                                           \
  }
  SCENEFILE_GL_FUNCTIONS(ROW)
#undef ROW
  return {};
}

}  // namespace scenefile::gl
