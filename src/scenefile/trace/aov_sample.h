#pragma once
// What the camera rays of a pixel hit, for layers, denoising and explain.h.

#include "scenefile/trace/camera_rays.h"
#include "scenefile/trace/color.h"
#include "scenefile/trace/denoise.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace scenefile {

/// Where a camera ray hit a surface.
struct AovHit {
  bool hit = false;
  glm::dvec3 position{0};  ///< world space
  glm::dvec2 uv{0};
  std::uint32_t source = 0;  ///< of the primitive: RenderPrimitive::source
};

/// A sample of a pixel: its color, and the surface that its camera ray hit.
struct AovSample : AovHit {
  CameraSample camera;
  Color color{0};
  glm::dvec3 normal{0};    ///< for shading, including the bump map
  Color albedo{0};         ///< the D of the lighting equation
  Color lit{0};            ///< diffuse and specular light of all lights
  Color diffused{0};       ///< the part of `lit` that is diffuse light from area lights
  Color unshadowed{0};     ///< `lit` without shadows
  int bounces = 0;         ///< maximum depth of reflections and refractions
  std::uint32_t rays = 0;  ///< camera, reflected and refracted rays
};

/// The samples of one pixel, in sampling order.
struct PixelAovs {
  std::vector<AovSample> samples;
  std::vector<Color> light_colors;  ///< by sample and separately recorded light
  AovHit center;                    ///< the surface at the center of the pixel, if requested

  void clear() {
    samples.clear();
    light_colors.clear();
  }
  /// Light of the sample from light `index` of the `lights` that are recorded separately.
  const Color& light_of(std::size_t sample, std::size_t index, std::size_t lights) const {
    return light_colors[sample * lights + index];
  }
};

/// Statistics of the samples of a pixel in the fine profile. `sharp`: see denoised(); then only
/// direct diffuse light from area lights, without the texture, counts as noisy.
PixelStatistics statistics_of(const std::vector<AovSample>& samples, bool sharp);

}  // namespace scenefile
