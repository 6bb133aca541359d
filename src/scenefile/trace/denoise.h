#pragma once
// Removes the noise of area lights and lenses without additional rays (fine profile).
//
// Each pixel becomes the weighted mean of the surrounding pixels that only differ by noise: their
// colors differ by no more than their uncertainty explains (non-local means over small patches),
// and normals, albedo and position belong to the same smooth surface. After Rousselle, Manzi and
// Zwicker, "Robust Denoising using Feature and Color Information", 2013.

#include <glm/glm.hpp>

#include <vector>

namespace scenefile {

/// Statistics of a pixel: means over its samples. The guides are those of the surfaces hit by
/// camera rays, 0 if there are none.
struct PixelStatistics {
  glm::vec3 signal{0};        ///< the noisy part: color = rest + scale * signal
  glm::vec3 scale{1};         ///< exact
  glm::vec3 rest{0};          ///< exact
  glm::vec3 variance{0};      ///< of `signal`; estimated
  glm::vec3 normal{0};        ///< world space; shorter than 1 if it varies
  glm::vec3 albedo{0};        ///< diffuse color
  glm::vec3 position{0};      ///< world space
  float coverage = 0;         ///< fraction of rays that hit a surface
  float normal_variance = 0;  ///< of `normal`, sum over its components; 0: exact
  float albedo_variance = 0;  ///< the same for `albedo`
};

/// The radius of the filter in pixels; pixels farther away have no effect.
inline constexpr int denoise_reach = 10;

/// The denoised colors, row by row like `pixels`. A signal changes by at most three standard errors
/// of its pixel, so exact values are unchanged. `sharp`: all samples of a pixel see the same place
/// of the scene, except for the extent of the pixel (no lens). Then guides mark edges exactly, the
/// signal is the light on the surface without its texture, and the albedo is not a guide.
/// `invisible`: pixels whose standard error is less are unchanged; the default suits values that 8
/// bits show. With 0 the result is proportional to the signals, for pictures of any brightness.
std::vector<glm::vec3> denoised(int width, int height, const std::vector<PixelStatistics>& pixels,
                                bool sharp, float invisible = 1.0f / 512);

}  // namespace scenefile
