#pragma once
// What the camera rays of a pixel met, for layers and for taking noise away.

#include "scenefile/trace/color.h"
#include "scenefile/trace/denoise.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

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

/// The samples of one pixel, in the order in which they were taken.
struct PixelSurfaces {
  std::vector<SurfaceSample> samples;
  std::vector<Color> light_colors;  ///< by sample and light that is kept apart

  void clear() {
    samples.clear();
    light_colors.clear();
  }
  /// Light of the sample, of the light number `index` of `lights` that are kept apart.
  const Color& light_of(std::size_t sample, std::size_t index, std::size_t lights) const {
    return light_colors[sample * lights + index];
  }
};

/// Of the samples of one pixel of the fine profile. `sharp`: see denoised(); only direct diffuse
/// light of area lights is taken for noisy then, apart from the texture that it falls on.
PixelStatistics statistics_of(const std::vector<SurfaceSample>& samples, bool sharp);

}  // namespace scenefile
