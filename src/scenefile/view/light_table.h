#pragma once
// Lights as the shaders take them. Internal to the room.

#include "scenefile/view/draw.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace scenefile {

/// A point that light comes from, or a direction. An area light is a grid of such points, each of
/// which shines like a spotlight of 90 degrees without fading.
struct Emitter {
  glm::dvec3 position{0};  ///< world space; for directional lights the direction to the light
  bool directional = false;
  glm::vec3 color{0};
  glm::vec3 attenuation{1, 0, 0};
  glm::vec3 axis{0, -1, 0};  ///< direction of travel of a spotlight
  float inner_angle = 10;    ///< radians; 10: not a spotlight
  float outer_angle = 10;
  glm::dvec3 shadow_from{0};  ///< where its shadows are seen from; not of directional lights
  std::uint32_t light = 0;    ///< into RenderScene::lights
};

/// Of the lights that shine by the options.
std::vector<Emitter> emitters(const std::vector<RenderLight>& lights, const DrawOptions& options);

/// Texels of an emitter, relative to the eye, as shaders/scene.frag reads them: position or
/// direction, and whether it has a place; color, shadow; attenuation, inner angle; axis, outer
/// angle; where shadows are seen from.
inline constexpr int emitter_texels = 5;
std::array<glm::vec4, emitter_texels> emitter_row(const Emitter& emitter, const glm::dvec3& eye,
                                                  int shadow);

}  // namespace scenefile
