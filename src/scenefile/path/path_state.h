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

/// Arrays hold the pixels of `region`, row by row.
struct PathState {
  PixelRegion region;                 ///< the crop, or the whole picture
  std::vector<glm::dvec3> sums;       ///< of the samples
  std::vector<double> squares;        ///< of the luminance of the samples
  std::vector<std::uint32_t> counts;  ///< samples; different between pixels only after cancelling
  std::uint64_t dropped = 0;          ///< samples that were not finite, and count as black
};

/// The state before the first sample.
PathState make_path_state(const RenderOptions& options);

struct PathScene;

/// Adds a sample to pixel `at` of the arrays. False if it is not finite: it counts as black.
bool add_sample(const Color& light, std::size_t at, PathState& state);

/// Adds samples to every pixel that has less than `samples`. `scene` must be the same for all
/// calls. Returns `complete`, `cancelled` if `progress` said so, or `limit_reached`. Adds the rays
/// of this call to `stats`.
RenderStatus add_samples(const PathScene& scene, std::uint32_t samples, PathState& state,
                         const Progress& progress, RenderStats& stats);

/// The mean of the samples; linear.
Image image_of(const PathState& state);

/// The variance of the mean of each pixel's luminance, assuming independent samples: an upper
/// bound, because they are stratified. 0 if there is only one sample.
std::vector<float> variances_of(const PathState& state);

}  // namespace scenefile
