#pragma once
// A path-traced picture in progress: sums over the samples so far, as plain data. More samples can
// be added at any time; n and then m samples give the same bytes as n + m.

#include "scenefile/asset/image.h"
#include "scenefile/trace/color.h"
#include "scenefile/trace/render.h"
#include "scenefile/trace/trace_scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace scenefile {

/// Sums over the samples of a pixel, for denoising.
struct PathGuides {
  glm::dvec3 emission{0};  ///< of the first surface toward the eye
  glm::dvec3 squares{0};   ///< of the samples without that emission
  glm::dvec3 normal{0};    ///< of the first surface
  glm::dvec3 albedo{0};    ///< all that it reflects
  double albedo_squares = 0;
};

/// Arrays hold the pixels of `region`, row by row.
struct PathState {
  PixelRegion region;  ///< the crop, or the whole picture; larger if denoising needs more pixels
  std::vector<glm::dvec3> sums;       ///< of the samples
  std::vector<double> squares;        ///< of the luminance of the samples
  std::vector<std::uint32_t> counts;  ///< samples; different between pixels only after cancelling
  std::vector<std::vector<glm::dvec3>> layers;  ///< by RenderOptions::layers: sums
  std::vector<PathGuides> guides;               ///< to denoise; otherwise empty
  std::uint64_t dropped = 0;  ///< samples that were not finite, and count as black
};

/// The crop, or the whole picture.
PixelRegion drawn_pixels(const RenderOptions& options);

/// The state before the first sample.
PathState make_path_state(const RenderOptions& options);

struct PathScene;

/// Adds a sample to pixel `at` of the arrays. False if it is not finite: it counts as black.
bool add_sample(const Color& light, std::size_t at, PathState& state);

/// Adds samples to every pixel that has less than `samples`. `scene` must be the same for all
/// calls. Returns `complete`, `cancelled` if `progress` said so, or `limit_reached`. Adds the rays
/// of this call to `stats`. `stride`: only pixels whose place in the region is divisible by it.
RenderStatus add_samples(const PathScene& scene, std::uint32_t samples, PathState& state,
                         const Progress& progress, RenderStats& stats, int stride = 1);

/// The mean of the samples; linear.
Image image_of(const PathState& state);

/// The same denoised: each pixel is a mean of pixels around it that only differ by noise
/// (trace/denoise.h). state.guides must be there.
Image denoised_image_of(const PathState& state);

/// The layers of the options for the pixels of `crop`, a part of state.region.
std::vector<ImageLayer> layers_of(const PathState& state, const RenderOptions& options,
                                  const PixelRegion& crop);

/// The variance of the mean of each pixel's luminance, assuming independent samples: an upper
/// bound, because they are stratified. 0 if there is only one sample.
std::vector<float> variances_of(const PathState& state);

}  // namespace scenefile
