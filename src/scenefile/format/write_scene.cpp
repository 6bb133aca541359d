#include "scenefile/format/write_scene.h"

#include "scenefile/format/dialects.h"

namespace scenefile {

std::string write_scene(const Scene& scene, SceneFormat format, const Limits& limits,
                        Diagnostics& diagnostics) {
  switch (format) {
    case SceneFormat::xml:
      return write_xml(scene, limits, diagnostics);
    case SceneFormat::json:
      return write_json(scene, limits, diagnostics);
  }
  return {};
}

}  // namespace scenefile
