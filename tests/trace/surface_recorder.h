#pragma once
// Records what the camera rays of a pixel hit, for the single-ray tracer.

#include "scenefile/trace/aov_sample.h"
#include "trace/recorder.h"

namespace scenefile {

class SurfaceRecorder final : public Recorder {
 public:
  /// `lights`: those to record separately, into RenderScene::lights of the scene.
  SurfaceRecorder(const RenderScene& scene, std::vector<std::uint32_t> lights)
      : scene_(scene), lights_(std::move(lights)) {}

  /// Starts a new pixel.
  void clear();

  const PixelAovs& surfaces() const { return surfaces_; }

  void begin_sample(const glm::dvec2& point, const glm::dvec2& lens) override;
  void end_sample(const Color& color) override;
  void begin_ray(RayKind kind, int depth, const Ray& ray, double start) override;
  void end_ray(const Color& color) override;
  void met(const Ray& ray, double start, const SurfacePoint& point) override;
  void surface(const SurfacePoint& bumped, const Color& ambient, const Color& diffuse,
               const Color& specular) override;
  void lit(const Illumination& light, double n_dot_l, double r_dot_v, const Color& diffuse,
           const Color& specular, const Color& contribution) override;
  void light(std::uint32_t index, std::uint32_t taken, const Color& contribution) override;

 private:
  bool at_camera_ray() const { return nesting_ == 1; }

  const RenderScene& scene_;
  std::vector<std::uint32_t> lights_;
  PixelAovs surfaces_;
  Color unshadowed_{0};  // of the current light
  Color diffused_{0};    // of that light
  int nesting_ = 0;      // number of nested rays
};

}  // namespace scenefile
