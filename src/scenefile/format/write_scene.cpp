#include "scenefile/format/write_scene.h"

#include "scenefile/format/dialects.h"
#include "scenefile/format/write_forms.h"

namespace scenefile {

std::string write_scene(const Scene& scene, SceneFormat format, const Limits& limits,
                        Diagnostics& diagnostics) {
  switch (format) {
    case SceneFormat::xml:
      return print_xml(xml_form(scene, limits, diagnostics), limits, diagnostics);
    case SceneFormat::json:
      return print_json(json_form(scene, diagnostics), limits, diagnostics);
  }
  return {};
}

}  // namespace scenefile
