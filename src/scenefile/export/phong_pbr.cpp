#include "scenefile/export/phong_pbr.h"

#include "scenefile/base/components.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

// The roughness of opaque surfaces without highlights. It has no effect in glTF, but in Blender
// diffuse surfaces brighten at grazing angles depending on it; this value is closest to Lambert's
// law.
constexpr float matte_roughness = 0.5f;
// Rougher nonmetals show highlights, but no mirror images.
constexpr float mirror_roughness = 0.05f;
constexpr float largest_shininess = 1000;

glm::vec3 unit_range(const glm::vec3& color) {
  return glm::clamp(color, glm::vec3(0), glm::vec3(1));
}

bool has_highlight(const PhongColors& phong) {
  return phong.shininess > 0 && largest(phong.specular) > 0;
}

float power4(float x) {
  return x * x * x * x;
}

// The color, scaled so that its largest component is at most 1.
glm::vec3 at_most_one(const glm::vec3& color) {
  return color / std::max(1.0f, largest(color));
}

}  // namespace

PhongColors phong_colors(const RenderMaterial& material, const RenderGlobal& global,
                         float transparent) {
  PhongColors phong;
  phong.ambient = global.ambient * material.ambient;
  phong.diffuse = global.diffuse * material.diffuse;
  phong.specular = global.specular * material.specular;
  phong.reflective = global.specular * material.reflective;
  phong.transparent = global.transparent.value_or(transparent) * material.transparent;
  phong.shininess = material.shininess;
  phong.ior = material.ior;
  return phong;
}

float f0_of(float ior) {
  const float root = (ior - 1) / (ior + 1);
  return root * root;
}

PbrMaterial pbr_of(const PhongColors& phong) {
  PbrMaterial pbr;
  const float through = std::clamp(largest(phong.transparent), 0.0f, 1.0f);
  const glm::vec3 diffuse = unit_range(phong.diffuse);
  pbr.base = unit_range(diffuse + glm::max(phong.transparent, glm::vec3(0)));
  pbr.transmission = through > 0 ? through / (through + std::max(0.0f, largest(diffuse))) : 0;
  pbr.ior = through > 0 ? std::max(1.0f, phong.ior) : 1.5f;
  pbr.emissive = glm::max(phong.ambient, glm::vec3(0));
  pbr.f0 = glm::vec3(0);
  pbr.roughness = through > 0 ? 0 : matte_roughness;
  if (largest(phong.reflective) > 0) {
    pbr.roughness = 0;
    pbr.f0 = unit_range(phong.reflective);
  } else if (has_highlight(phong) && pbr.transmission < 0.5f) {
    const float r4 = 1 / (2 * phong.shininess + 1);
    pbr.roughness = std::sqrt(std::sqrt(r4));
    pbr.f0 = unit_range(4 * r4 * phong.specular);
  }
  if (f0_of(pbr.ior) == 0) {
    pbr.f0 = glm::vec3(0);
  }
  return pbr;
}

PhongColors phong_of(const PbrMaterial& pbr) {
  PhongColors phong;
  phong.ambient = pbr.emissive;
  const float smooth = std::max(0.0f, 1 - 2 * pbr.roughness);
  const glm::vec3 metal = pbr.metallic * pbr.base;
  const float rest = 1 - pbr.metallic;
  phong.diffuse = rest * (1 - pbr.transmission) * pbr.base + (1 - smooth) * metal;
  phong.transparent = rest * pbr.transmission * pbr.base;
  phong.ior = pbr.transmission > 0 ? pbr.ior : 1;
  phong.reflective = smooth * metal;
  const glm::vec3 f0 = rest * pbr.f0 + metal;
  const float r4 = power4(pbr.roughness);
  if (pbr.roughness <= mirror_roughness) {
    phong.reflective += rest * pbr.f0;
  } else if (r4 < 1 && largest(f0) > 0) {
    phong.shininess = std::min(largest_shininess, (1 / r4 - 1) / 2);
    phong.specular = at_most_one(f0 * (2 * phong.shininess + 1) / 4.0f);
  }
  return phong;
}

}  // namespace scenefile
