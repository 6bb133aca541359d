#pragma once
// Lights in the form that the shaders use. Internal to view.

#include "scenefile/view/draw.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace scenefile {

/// A point light or a direction. An area light is a grid of such points, each a spotlight of 90
/// degrees without falloff toward the edge.
struct Emitter {
  glm::dvec3 position{0};  ///< world space; for directional lights the direction to the light
  bool directional = false;
  glm::vec3 color{0};
  glm::vec3 attenuation{1, 0, 0};
  glm::vec3 axis{0, -1, 0};  ///< direction of travel of a spotlight
  float inner_angle = 10;    ///< radians; 10: not a spotlight
  float outer_angle = 10;
  glm::dvec3 shadow_from{0};  ///< center of its shadow map; not for directional lights
  std::uint32_t light = 0;    ///< into RenderScene::lights
};

/// For the lights that are on.
std::vector<Emitter> emitters(const std::vector<RenderLight>& lights, const DrawOptions& options);

/// The texels of an emitter, relative to the eye, as read by shaders/scene.frag: position or
/// direction, and which of them; color, shadow code; attenuation, inner angle; axis, outer angle;
/// center of the shadow map.
inline constexpr int emitter_texels = 5;
std::array<glm::vec4, emitter_texels> emitter_row(const Emitter& emitter, const glm::dvec3& eye,
                                                  int shadow);

}  // namespace scenefile
