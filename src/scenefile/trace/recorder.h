#pragma once
// Records what the tracer computes for a pixel. Internal to the room; for results see explain.h.
//
// The tracer has a pointer to a recorder, null in every render, which it checks once per event; a
// ray costs a thousand times more.

#include "scenefile/trace/explain.h"
#include "scenefile/trace/lights.h"
#include "scenefile/trace/surface_point.h"
#include "scenefile/trace/tracer.h"

#include <optional>
#include <vector>

namespace scenefile {

class Recorder {
 public:
  virtual ~Recorder() = default;

  virtual void begin_sample(const glm::dvec2& /*point*/, const glm::dvec2& /*lens*/) {}
  virtual void end_sample(const Color& /*color*/) {}

  /// A ray and everything up to its end belongs to it. Rays nest.
  virtual void begin_ray(RayKind /*kind*/, int /*depth*/, const Ray& /*ray*/, double /*start*/) {}
  virtual void end_ray(const Color& /*color*/) {}

  /// The next refracted ray is reflected instead: total internal reflection.
  virtual void total_reflection() {}
  /// The current ray passed through a wall, or was reflected there; `normal` points against the
  /// ray.
  virtual void wall(const Ray& /*ray*/, double /*start*/, const SurfacePoint& /*point*/,
                    const glm::dvec3& /*normal*/, const glm::dvec3& /*direction*/,
                    bool /*mirrored*/) {}
  /// The current ray was reflected inside an object more often than max_depth allows.
  virtual void trapped() {}
  /// The current ray hit a surface to shade; before the bump map.
  virtual void met(const Ray& /*ray*/, double /*start*/, const SurfacePoint& /*point*/) {}
  /// The color of a texture at that point.
  virtual void textured(const Texture& /*texture*/, const RenderMaterial& /*material*/,
                        const glm::dvec2& /*uv*/, const Color& /*color*/) {}
  /// The terms of the lighting equation that do not depend on lights.
  virtual void surface(const SurfacePoint& /*bumped*/, const Color& /*ambient*/,
                       const Color& /*diffuse*/, const Color& /*specular*/) {}
  /// A shadow ray, and the fraction of light that it left. Called before the sample of its light.
  virtual void shadow(const Ray& /*ray*/, double /*start*/, double /*end*/, const Color& /*left*/) {
  }
  /// A sample of a light. Called before the light.
  virtual void lit(const Illumination& /*light*/, double /*n_dot_l*/, double /*r_dot_v*/,
                   const Color& /*diffuse*/, const Color& /*specular*/,
                   const Color& /*contribution*/) {}
  virtual void light(std::uint32_t /*index*/, std::uint32_t /*taken*/,
                     const Color& /*contribution*/) {}
  virtual void light_of_other_mode(std::uint32_t /*index*/) {}
  /// That point is on a wall of the object that the ray is inside of, and is not shaded.
  virtual void inner_wall() {}
  virtual void shaded(const Color& /*local*/) {}
  virtual void branches(const BranchRecord& /*mirror*/, const BranchRecord& /*glass*/) {}
  virtual void summed(const Color& /*sum*/) {}
};

/// Records a pixel for explain.h.
class PixelRecorder final : public Recorder {
 public:
  /// Records the rays only for the sample `shown`; for the others, what SampleRecord contains.
  PixelRecorder(const Tracer& tracer, std::optional<std::uint32_t> shown);

  void begin_sample(const glm::dvec2& point, const glm::dvec2& lens) override;
  void end_sample(const Color& color) override;
  void begin_ray(RayKind kind, int depth, const Ray& ray, double start) override;
  void end_ray(const Color& color) override;
  void total_reflection() override { total_reflection_ = true; }
  void wall(const Ray& ray, double start, const SurfacePoint& point, const glm::dvec3& normal,
            const glm::dvec3& direction, bool mirrored) override;
  void trapped() override;
  void met(const Ray& ray, double start, const SurfacePoint& point) override;
  void textured(const Texture& texture, const RenderMaterial& material, const glm::dvec2& uv,
                const Color& color) override;
  void surface(const SurfacePoint& bumped, const Color& ambient, const Color& diffuse,
               const Color& specular) override;
  void shadow(const Ray& ray, double start, double end, const Color& left) override;
  void lit(const Illumination& light, double n_dot_l, double r_dot_v, const Color& diffuse,
           const Color& specular, const Color& contribution) override;
  void light(std::uint32_t index, std::uint32_t taken, const Color& contribution) override;
  void light_of_other_mode(std::uint32_t index) override;
  void inner_wall() override;
  void shaded(const Color& local) override;
  void branches(const BranchRecord& mirror, const BranchRecord& glass) override;
  void summed(const Color& sum) override;

  std::vector<SampleRecord> samples;
  std::vector<RayRecord> rays;  ///< of the shown sample

 private:
  RayRecord* current();
  ObjectRef object_at(const Ray& ray, double start, const Hit& hit) const;
  std::vector<Blocker> blockers(const Ray& ray, double start, double end) const;

  const Tracer& tracer_;
  std::optional<std::uint32_t> shown_;
  bool in_full_ = false;              // the current sample is the shown one
  std::vector<std::uint32_t> stack_;  // the current ray and its ancestors
  bool total_reflection_ = false;
  std::optional<Hit> met_;  // by the current ray; for occluders that are the object itself
  LightSample pending_shadow_;
  std::vector<LightSample> pending_samples_;
};

}  // namespace scenefile
