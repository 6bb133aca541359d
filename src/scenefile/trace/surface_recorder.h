#pragma once
// What the camera rays of a pixel met, for layers and for taking noise away.

#include "scenefile/trace/denoise.h"
#include "scenefile/trace/recorder.h"

namespace scenefile {

/// A sample of a pixel: the color and the surface that its camera ray met.
struct SurfaceSample {
  glm::dvec2 point{0};  ///< of the picture
  Color color{0};
  bool hit = false;
  glm::dvec3 normal{0};    ///< for shading, bump map included
  glm::dvec3 position{0};  ///< world space
  Color albedo{0};         ///< the D of the lighting equation
  Color lit{0};            ///< diffuse and specular light of all lights
  Color diffused{0};       ///< the diffuse part of `lit` that area lights sent
  Color unshadowed{0};     ///< `lit` without shadows
  int bounces = 0;         ///< most reflections and refractions behind each other
};

class SurfaceRecorder final : public Recorder {
 public:
  /// `lights`: whose light is to be kept apart, into RenderScene::lights of the scene.
  SurfaceRecorder(const RenderScene& scene, std::vector<std::uint32_t> lights)
      : scene_(scene), lights_(std::move(lights)) {}

  /// Starts another pixel.
  void clear();

  const std::vector<SurfaceSample>& samples() const { return samples_; }
  /// Light of the sample that comes from lights[index].
  const Color& light_of(std::size_t sample, std::size_t index) const {
    return light_colors_[sample * lights_.size() + index];
  }

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
  std::vector<SurfaceSample> samples_;
  std::vector<Color> light_colors_;  // by sample and light
  Color unshadowed_{0};              // of the light that is being asked
  Color diffused_{0};                // of that light
  int nesting_ = 0;                  // rays inside each other
};

/// Of the samples of one pixel of the fine profile. `sharp`: see denoised(); only direct diffuse
/// light of area lights is taken for noisy then, apart from the texture that it falls on.
PixelStatistics statistics_of(const std::vector<SurfaceSample>& samples, bool sharp);

}  // namespace scenefile
