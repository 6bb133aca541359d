#include "scenefile/mistakes/hypothesis_list.h"

#include <algorithm>

namespace scenefile {

HypothesisList::HypothesisList(const SceneView& scene_view, int picture_width, int picture_height)
    : view(scene_view), scene(*scene_view.scene), width(picture_width), height(picture_height) {
  for (const RenderGroup& group : scene.groups) {
    for (const RenderPrimitive& p : group.primitives) {
      shapes.insert(p.shape);
    }
  }
  for (const RenderLight& light : scene.lights) {
    types.insert(light.type);
  }
}

bool HypothesisList::mirrors() const {
  return ray_mode() && view.options.features.reflect &&
         any_material([](const RenderMaterial& m) { return m.reflective != glm::vec3(0); });
}

bool HypothesisList::glass() const {
  return ray_mode() && view.options.features.refract &&
         any_material([](const RenderMaterial& m) { return m.transparent != glm::vec3(0); });
}

bool HypothesisList::shadows() const {
  return ray_mode() && view.options.features.shadows && !scene.lights.empty();
}

bool HypothesisList::textured() const {
  return ray_mode() && view.options.features.texture &&
         any_material([](const RenderMaterial& m) { return m.texture.used() && m.blend != 0; });
}

bool HypothesisList::any_type(bool (*is)(LightType)) const {
  return std::any_of(types.begin(), types.end(), is);
}

bool HypothesisList::any_light(const std::function<bool(const RenderLight&)>& is) const {
  return std::any_of(scene.lights.begin(), scene.lights.end(), is);
}

bool HypothesisList::any_material(bool (*is)(const RenderMaterial&)) const {
  return std::any_of(scene.materials.begin(), scene.materials.end(), is);
}

void HypothesisList::add(Cause cause, std::string_view what, std::function<void(Trial&)> draw,
                         Stage stage) {
  items.push_back({cause, std::string(what), stage, std::move(draw), {}, {}});
}

}  // namespace scenefile
