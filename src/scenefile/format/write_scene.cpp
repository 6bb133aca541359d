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

std::string_view SceneListing::line(std::size_t index) const {
  const std::size_t end = index + 1 < lines.size() ? lines[index + 1].begin : text.size();
  const std::string_view all = std::string_view(text).substr(0, end);
  return all.substr(lines[index].begin, all.find_last_not_of(",\n") + 1 - lines[index].begin);
}

SceneListing list_scene(const Scene& scene, SceneFormat format) {
  Scene effective = scene;
  effective.name.clear();
  effective.camera = scene.camera.value_or(Camera());
  for (Node& node : effective.nodes) {
    for (Light& light : node.lights) {
      light.name.clear();
    }
  }
  return format == SceneFormat::xml ? list_xml(effective) : list_json(effective);
}

}  // namespace scenefile
