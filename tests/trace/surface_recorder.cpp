#include "trace/surface_recorder.h"

#include <algorithm>

namespace scenefile {

void SurfaceRecorder::clear() {
  surfaces_.clear();
}

void SurfaceRecorder::begin_sample(const glm::dvec2& point, const glm::dvec2& lens) {
  CameraSample& sample = surfaces_.samples.emplace_back().camera;
  sample.point = point;
  sample.lens = lens;
  surfaces_.light_colors.resize(surfaces_.samples.size() * lights_.size(), Color(0));
  nesting_ = 0;
}

void SurfaceRecorder::end_sample(const Color& color) {
  surfaces_.samples.back().color = color;
}

void SurfaceRecorder::begin_ray(RayKind /*kind*/, int depth, const Ray& /*ray*/, double /*start*/) {
  ++nesting_;
  ++surfaces_.samples.back().rays;
  surfaces_.samples.back().bounces = std::max(surfaces_.samples.back().bounces, depth);
}

void SurfaceRecorder::end_ray(const Color& /*color*/) {
  --nesting_;
}

void SurfaceRecorder::met(const Ray& /*ray*/, double /*start*/, const SurfacePoint& point) {
  if (at_camera_ray()) {
    surfaces_.samples.back().hit = true;
    surfaces_.samples.back().normal = point.normal;
    surfaces_.samples.back().position = point.position;
    surfaces_.samples.back().uv = point.object.uv;
    surfaces_.samples.back().source = point.hit.source;
  }
}

void SurfaceRecorder::surface(const SurfacePoint& bumped, const Color& /*ambient*/,
                              const Color& diffuse, const Color& /*specular*/) {
  if (at_camera_ray()) {
    surfaces_.samples.back().normal = bumped.normal;
    surfaces_.samples.back().albedo = diffuse;
  }
}

void SurfaceRecorder::lit(const Illumination& light, double /*n_dot_l*/, double /*r_dot_v*/,
                          const Color& diffuse, const Color& specular, const Color& contribution) {
  const Color share = diffuse + specular;
  unshadowed_ += share * light.color;
  for (int c = 0; c < 3; ++c) {
    diffused_[c] += share[c] > 0 ? contribution[c] * diffuse[c] / share[c] : 0;
  }
}

void SurfaceRecorder::light(std::uint32_t index, std::uint32_t taken, const Color& contribution) {
  if (at_camera_ray()) {
    surfaces_.samples.back().lit += contribution;
    surfaces_.samples.back().unshadowed += unshadowed_ / double(taken);
    if (scene_.lights[index].type == LightType::area) {
      surfaces_.samples.back().diffused += diffused_ / double(taken);
    }
    Color* const colors =
        surfaces_.light_colors.data() + (surfaces_.samples.size() - 1) * lights_.size();
    for (std::size_t i = 0; i < lights_.size(); ++i) {
      colors[i] = lights_[i] == index ? contribution : colors[i];
    }
  }
  unshadowed_ = diffused_ = Color(0);
}

}  // namespace scenefile
