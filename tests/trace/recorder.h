#pragma once
// Records what the scalar tracer computes.

#include "scenefile/trace/explain.h"
#include "scenefile/trace/surface_point.h"
#include "scenefile/trace/texture_lookup.h"
#include "scenefile/trace/tracer.h"
#include "trace/scalar_lights.h"

namespace scenefile {

class Recorder;

/// Counters of the scalar tracer.
struct ScalarCounts : RayCounts {
  std::uint64_t penumbras = 0;   ///< area lights seen partially
  Recorder* recorder = nullptr;  ///< null: not recording
};

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

}  // namespace scenefile
