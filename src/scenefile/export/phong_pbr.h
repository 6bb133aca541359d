#pragma once
// Converts between the format's Phong materials and the metallic-roughness materials of glTF 2.0.
// Both directions are in one file, so that each inverts the other.
//
// Convention: a light of color c has pi * c lux (or candela per square distance), so that a matte
// surface with base color D, lit perpendicularly, has the radiance c * D, as in the format.
//
// diffuse      -> base color
// ambient      -> emission: light that does not depend on the lights
// specular     -> reflectance at normal incidence F0 and roughness r, matching the height and width
//                 of the highlight: (R.V)^n is nearly (N.H)^(4n), GGX with alpha = r * r is nearly
//                 (N.H)^(2 / alpha^2 - 2), hence r^4 = 1 / (2n + 1) and F0 = 4 r^4 ks Cs.
//                 (B. Walter et al., Microfacet Models for Refraction through Rough Surfaces, 2007,
//                 equation 33.)
// reflective   -> F0 of a surface with roughness 0; the highlight, which needs another roughness,
//                 is lost
// transparent  -> transmission: the share of transparent in diffuse + transparent. From a share of
//                 0.5 on, the surface is smooth, and its highlight is lost: a rough surface would
//                 blur what is seen through it

#include "scenefile/scene/render_scene.h"

#include <glm/glm.hpp>

namespace scenefile {

/// A Phong material multiplied by the scene's coefficients. Linear colors.
struct PhongColors {
  glm::vec3 ambient{0};
  glm::vec3 diffuse{1};
  glm::vec3 specular{0};
  glm::vec3 reflective{0};
  glm::vec3 transparent{0};
  float shininess = 0;  ///< exponent; 0: no highlight
  float ior = 1;        ///< > 0

  friend bool operator==(const PhongColors&, const PhongColors&) = default;
};

/// A glTF material, including the extensions for specular, transmission and ior.
struct PbrMaterial {
  glm::vec3 base{1};       ///< 0 to 1
  float metallic = 0;      ///< 0 to 1
  float roughness = 1;     ///< 0 to 1
  glm::vec3 f0{0.04f};     ///< reflectance of the non-metallic part at normal incidence; 0 to 1
  float transmission = 0;  ///< 0 to 1
  float ior = 1.5f;        ///< >= 1
  glm::vec3 emissive{0};   ///< any strength
};

/// `transparent`: the coefficient to use if the scene gives none.
PhongColors phong_colors(const RenderMaterial& material, const RenderGlobal& global,
                         float transparent);

PbrMaterial pbr_of(const PhongColors& phong);
PhongColors phong_of(const PbrMaterial& pbr);

/// Reflectance at normal incidence of a smooth surface between air and a medium with this ior.
float f0_of(float ior);

}  // namespace scenefile
