#include "scenefile/trace/tracer.h"

#include "scenefile/base/one_lane.h"
#include "scenefile/base/vector-inl.h"
#include "scenefile/trace/optics-inl.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

// Values out of range become the nearest that the app may get, as its own checks have it.
RenderOptions in_range(RenderOptions options) {
  options.width = std::max(1, options.width);
  options.height = std::max(1, options.height);
  options.samples = std::clamp(options.samples, 1, 1 << 20);
  options.threads = std::clamp(options.threads, 0, 1024);
  options.max_depth = std::clamp(options.max_depth, 0, 64);
  if (options.crop.has_value()) {
    PixelRegion& crop = *options.crop;
    crop.x0 = std::clamp(crop.x0, 0, options.width - 1);
    crop.y0 = std::clamp(crop.y0, 0, options.height - 1);
    crop.x1 = std::clamp(crop.x1, crop.x0 + 1, options.width);
    crop.y1 = std::clamp(crop.y1, crop.y0 + 1, options.height);
  }
  options.fresnel = options.fresnel && options.profile == Profile::fine;
  return options;
}

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

Tracer::Tracer(const RenderScene& s, const Assets& a, const RenderOptions& o, Instances instances)
    : scene(s),
      assets(a),
      options(in_range(o)),
      transparent(transparent_coefficient(s, o.profile)),
      accelerator(s, a, {instances, mesh_distance(o.profile)}),
      transmission(shadow_factors(s, o, transparent)),
      pyramids(make_pyramids(a, o)) {}

RenderStatus Tracer::status() const {
  switch (accelerator.status()) {
    case AcceleratorStatus::ready:
      break;
    case AcceleratorStatus::too_deep:
      return RenderStatus::limit_reached;
    case AcceleratorStatus::out_of_memory:
      return RenderStatus::failed;
  }
  return accelerator.overwhelmed() ? RenderStatus::limit_reached : RenderStatus::complete;
}

CameraRays Tracer::camera() const {
  RenderCamera lens = scene.camera;
  if (!options.features.depthoffield) {
    lens.aperture = 0;
  }
  return {lens, options.width, options.height};
}

double Tracer::start_offset(const glm::dvec3& point, double distance) const {
  return course() ? one::course_offset : one::fine_offset(one::splat3(point), distance);
}

Color Tracer::transparency(const RenderMaterial& material) const {
  return transparent * Color(material.transparent);
}

}  // namespace scenefile
