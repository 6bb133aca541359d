#include "scenefile/import/complete_scene.h"

#include "scenefile/base/text.h"
#include "scenefile/import/codes.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

void complete_scene(Scene& scene, const Bounds& box, Diagnostics& diagnostics) {
  if (!scene.camera) {
    Camera& camera = scene.camera.emplace();
    const glm::dvec3 look = glm::normalize(glm::dvec3(-1, -0.7, -1.5));
    const glm::dvec3 middle = box.empty() ? glm::dvec3(0) : 0.5 * (box.min + box.max);
    const double radius = box.empty() ? 1 : std::max(1e-6, 0.5 * glm::distance(box.min, box.max));
    const double half_angle = glm::radians(double(camera.height_angle_deg)) / 2;
    camera.look = glm::vec3(look);
    camera.position = glm::vec3(middle - look * (radius / std::sin(half_angle)));
    diagnostics.report("import.added"_code, {}, "a camera is added that shows the whole model");
  }
  if (scene.nodes[scene.root].lights.empty()) {
    Light light;
    light.type = LightType::directional;
    light.direction = {-0.5f, -1, -0.7f};
    scene.nodes[scene.root].lights.push_back(light);
    diagnostics.report("import.added"_code, {}, "a light from above is added");
  }
}

std::string node_name(std::string_view name) {
  std::size_t size = std::min<std::size_t>(name.size(), 200);
  while (size > 0 && size < name.size() && continues_character(name[size])) {
    --size;
  }
  return std::string(name.substr(0, size));
}

void report_emission(Diagnostics& diagnostics) {
  diagnostics.report("import.left-out"_code, {},
                     "what materials emit becomes their ambient color, which lights nothing else");
}

}  // namespace scenefile
