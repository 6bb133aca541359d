#include "scenefile/trace/tracer.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

double transparent_coefficient(const RenderScene& scene, Profile profile) {
  return scene.global.transparent.value_or(profile == Profile::course ? 0.0f : 0.5f);
}

std::vector<glm::dvec3> shadow_factors(const RenderScene& scene, const RenderOptions& options,
                                       double transparent) {
  const bool through = options.profile == Profile::fine && options.features.refract;
  std::vector<glm::dvec3> factors;
  factors.reserve(scene.materials.size());
  for (const RenderMaterial& material : scene.materials) {
    factors.push_back(through ? transparent * glm::dvec3(material.transparent) : glm::dvec3(0));
  }
  return factors;
}

std::vector<Pyramid> make_pyramids(const Assets& assets, const RenderOptions& options) {
  std::vector<Pyramid> pyramids;
  if (options.profile != Profile::fine || options.mode != Mode::ray || !options.features.texture) {
    return pyramids;
  }
  pyramids.reserve(assets.textures.size());
  for (const Texture& texture : assets.textures) {
    pyramids.emplace_back(texture);
  }
  return pyramids;
}

}  // namespace

Tracer::Tracer(const RenderScene& s, const Assets& a, const RenderOptions& o)
    : scene(s),
      assets(a),
      options(o),
      transparent(transparent_coefficient(s, o.profile)),
      accelerator(s, a),
      transmission(shadow_factors(s, o, transparent)),
      pyramids(make_pyramids(a, o)) {}

double Tracer::start_offset(const glm::dvec3& point, double distance) const {
  if (course()) {
    return 1e-3;
  }
  // Hits are exact to about 1e-15 of the numbers involved.
  const glm::dvec3 size = glm::abs(point);
  return 1e-9 * (std::max({size.x, size.y, size.z}) + distance);
}

Color Tracer::transparency(const RenderMaterial& material) const {
  return transparent * Color(material.transparent);
}

}  // namespace scenefile
