#pragma once
// Light that arrives at a point, ignoring occluders.

#include "scenefile/scene/render_scene.h"

#include <glm/glm.hpp>

namespace scenefile {

struct Illumination {
  glm::dvec3 to_light{0};  ///< unit length
  double distance = 0;     ///< infinite for directional lights
  double attenuation = 1;
  double spot_factor = 1;
  glm::dvec3 color{0};  ///< includes attenuation and spot factor
};

/// The fraction of full light at `distance` world units: 1 / (c1 + c2 d + c3 d^2), at most 1.
double attenuation(const glm::vec3& coefficients, double distance);

/// Share of full light at an angle (given by its cosine) from the axis of a spot: 1 up to the inner
/// angle, a smoothstep of the angle down to 0 at the outer.
double spot_factor(const RenderLight& light, double cosine);

/// `cosine` to the power `shininess`, both positive: the strength of a highlight.
double highlight(double cosine, double shininess);

/// `on_light` in [0, 1]^2 selects a point of an area light. Returns false if no light arrives: the
/// point is outside a spotlight's cone, behind an area light, or at the light itself.
bool illuminate(const RenderLight& light, const glm::dvec3& point, const glm::dvec2& on_light,
                Illumination& result);

}  // namespace scenefile
