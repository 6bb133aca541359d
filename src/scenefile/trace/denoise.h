#pragma once
// Noise of area lights and lenses, removed without new rays (fine profile).
//
// A pixel becomes the weighted mean of the pixels around it that look alike but for noise: their
// colors differ by no more than their uncertainty lets expect (non-local means over small patches),
// and normals, albedo and place are those of one smooth surface. After Rousselle, Manzi and
// Zwicker, "Robust Denoising using Feature and Color Information", 2013.

#include <glm/glm.hpp>

#include <vector>

namespace scenefile {

/// What is known of a pixel, means over its samples. The guides are those of the surfaces that the
/// camera rays met, 0 where they met none.
struct PixelStatistics {
  glm::vec3 signal{0};        ///< what is noisy of the color: color = rest + scale * signal
  glm::vec3 scale{1};         ///< exact
  glm::vec3 rest{0};          ///< exact
  glm::vec3 variance{0};      ///< of `signal`, estimated
  glm::vec3 normal{0};        ///< world space; shorter than 1 where it varies
  glm::vec3 albedo{0};        ///< diffuse color
  glm::vec3 position{0};      ///< world space
  float coverage = 0;         ///< share of rays that met a surface
  float normal_variance = 0;  ///< of `normal`, sum over its components; 0: exact
  float albedo_variance = 0;  ///< the same of `albedo`
};

/// How far a pixel looks around, in pixels; what lies further away has no effect on it.
inline constexpr int denoise_reach = 10;

/// The colors without noise, row after row as `pixels`. No signal moves by more than three standard
/// errors of its pixel: what is certain stays as it is. `sharp`: every sample of a pixel saw the
/// same place of the scene but for the extent of the pixel (no lens), so that guides mark edges
/// exactly, and the signal is the light on the surface without its texture: the albedo is no guide.
std::vector<glm::vec3> denoised(int width, int height, const std::vector<PixelStatistics>& pixels,
                                bool sharp);

}  // namespace scenefile
