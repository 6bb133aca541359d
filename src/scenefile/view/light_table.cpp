#include "scenefile/view/light_table.h"

#include "scenefile/base/realtime.h"
#include "scenefile/base/shape_traits.h"

namespace scenefile {

namespace {

// Points along each side of an area light: the grid of the course profile; without shadows it is as
// good as the many points of the fine profile.
constexpr int area_side = 4;
constexpr float right_angle = 1.57079633f;

Emitter emitter_of(const RenderLight& light, std::uint32_t index) {
  Emitter emitter;
  emitter.light = index;
  emitter.color = light.color;
  emitter.directional = !has_position(light.type);
  if (emitter.directional) {
    emitter.position = -glm::dvec3(light.direction);
  } else {
    emitter.position = light.position;
    emitter.attenuation = light.attenuation;
    emitter.axis = light.direction;
  }
  emitter.shadow_from = emitter.position;
  if (has_cone(light.type)) {
    emitter.inner_angle = light.inner_angle;
    emitter.outer_angle = light.outer_angle;
  }
  return emitter;
}

void add_area(const RenderLight& light, std::uint32_t index, std::vector<Emitter>& result) {
  Emitter emitter = emitter_of(light, index);
  emitter.color /= static_cast<float>(area_side * area_side);
  emitter.inner_angle = emitter.outer_angle = right_angle;
  for (int i = 0; i < area_side * area_side; ++i) {
    const double u = (2 * (i % area_side) + 1.0) / area_side - 1;
    const double v = (2 * (i / area_side) + 1.0) / area_side - 1;
    emitter.position =
        glm::dvec3(light.position) + u * glm::dvec3(light.half_u) + v * glm::dvec3(light.half_v);
    emitter.shadow_from = glm::dvec3(light.position) +
                          (u < 0 ? -0.5 : 0.5) * glm::dvec3(light.half_u) +
                          (v < 0 ? -0.5 : 0.5) * glm::dvec3(light.half_v);
    result.push_back(emitter);
  }
}

bool shines(const RenderLight& light, std::uint32_t index, const DrawOptions& options) {
  return (index >= options.lights.size() || options.lights[index]) &&
         (!options.directional_only || is_in_intersect(light.type)) &&
         (!options.realtime || has_light(options.realtime->milestone, light.type));
}

}  // namespace

std::vector<Emitter> emitters(const std::vector<RenderLight>& lights, const DrawOptions& options) {
  std::vector<Emitter> result;
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    if (!shines(lights[i], i, options)) {
      continue;
    }
    if (has_rectangle(lights[i].type)) {
      add_area(lights[i], i, result);
    } else {
      result.push_back(emitter_of(lights[i], i));
    }
  }
  return result;
}

std::array<glm::vec4, emitter_texels> emitter_row(const Emitter& emitter, const glm::dvec3& eye,
                                                  int shadow) {
  const glm::vec3 place(emitter.directional ? emitter.position : emitter.position - eye);
  return {glm::vec4(place, emitter.directional ? 0 : 1),
          glm::vec4(emitter.color, static_cast<float>(shadow)),
          glm::vec4(emitter.attenuation, emitter.inner_angle),
          glm::vec4(emitter.axis, emitter.outer_angle),
          glm::vec4(glm::vec3(emitter.shadow_from - eye), 0)};
}

}  // namespace scenefile
