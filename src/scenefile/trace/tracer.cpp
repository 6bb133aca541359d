#include "scenefile/trace/tracer.h"

#include "scenefile/base/shape_traits.h"

namespace scenefile {

namespace {

MeshDistance mesh_distance(Profile profile) {
  return profile == Profile::course ? MeshDistance::of_mesh : MeshDistance::of_world;
}

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

std::span<const MipMap> mip_maps_of(const TraceScene& traced, const RenderOptions& options) {
  if (options.profile != Profile::fine || options.mode != Mode::ray || !options.features.texture) {
    return {};
  }
  return traced.mip_maps();
}

}  // namespace

Tracer::Tracer(const TraceScene& t, const RenderScene& s, const RenderOptions& o)
    : traced(t),
      scene(s),
      assets(traced.assets()),
      options(in_range(o)),
      transparent(transparent_coefficient(s, o.profile)),
      accelerator(traced.accelerator(), mesh_distance(o.profile)),
      transmission(shadow_factors(s, o, transparent)),
      mip_maps(mip_maps_of(traced, o)) {}

Tracer::Tracer(const RenderScene& s, const Assets& a, const RenderOptions& o)
    : Tracer(TraceScene(s, a, {.threads = o.threads}), s, o) {}

RenderStatus Tracer::status() const {
  const RenderStatus built = traced.status();
  return built == RenderStatus::complete && accelerator.overwhelmed() ? RenderStatus::limit_reached
                                                                      : built;
}

CameraRays Tracer::camera() const {
  RenderCamera lens = scene.camera;
  if (!options.features.depthoffield) {
    lens.aperture = 0;
  }
  return {lens, options.width, options.height};
}

bool Tracer::uses(const RenderLight& light) const {
  return !(options.mode == Mode::intersect && course()) || is_in_intersect(light.type);
}

Color Tracer::transparency(const RenderMaterial& material) const {
  return transparent * Color(material.transparent);
}

}  // namespace scenefile
