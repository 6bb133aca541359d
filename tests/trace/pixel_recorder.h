#pragma once
// Records samples and rays in the form of explain.h.

#include "trace/recorder.h"

#include <optional>
#include <vector>

namespace scenefile {

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
