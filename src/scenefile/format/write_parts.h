#pragma once
// What both writers say in the same order under the same names. Private to the room. A printer has
// value(name, float), vector(name, vec3), color(name, vec3), texture(use) and bump_map(use).

#include "scenefile/scene/scene.h"

#include <string_view>

namespace scenefile {

/// Where the light shines, as its type has it.
template <typename Printer>
void print_beam(Printer& to, const Light& light) {
  if (light.type != LightType::point) {
    to.vector("direction", light.direction);
  }
  if (light.type == LightType::spot) {
    to.value("penumbra", light.penumbra_deg);
    if (light.angle_deg) {
      to.value("angle", *light.angle_deg);
    }
  }
  if (light.type == LightType::area) {
    to.value("width", light.width);
    to.value("height", light.height);
  }
}

/// What is not the default.
template <typename Printer>
void print_material(Printer& to, const Material& material) {
  const Material defaults;
  const auto color = [&](std::string_view name, glm::vec3 Material::*member) {
    if (material.*member != defaults.*member) {
      to.color(name, material.*member);
    }
  };
  const auto value = [&](std::string_view name, float Material::*member) {
    if (material.*member != defaults.*member) {
      to.value(name, material.*member);
    }
  };
  color("diffuse", &Material::diffuse);
  color("ambient", &Material::ambient);
  color("specular", &Material::specular);
  value("shininess", &Material::shininess);
  color("reflective", &Material::reflective);
  color("transparent", &Material::transparent);
  value("ior", &Material::ior);
  if (material.texture) {
    to.texture(*material.texture);
  }
  value("blend", &Material::blend);
  if (material.bump_map) {
    to.bump_map(*material.bump_map);
  }
}

}  // namespace scenefile
