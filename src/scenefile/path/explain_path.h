#pragma once
// Explains a pixel of mode path: its samples, and everything that one of them computed.

#include "scenefile/path/path_record.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace scenefile {

/// A sample of the pixel.
struct PathSample {
  glm::dvec2 point{0};  ///< of the picture, in pixels, y down
  glm::dvec2 lens{0};   ///< in apertures
  Color light{0};
  std::uint32_t surfaces = 0;  ///< that the path met
};

/// The picture's pixel is the sum of the samples in their order, divided by their number, as
/// floats. Samples that are not finite count as 0.
struct PathPixel {
  int x = 0;
  int y = 0;
  RenderOptions options;
  std::vector<PathSample> samples;
  std::uint32_t shown = 0;  ///< the sample that `path` describes
  PathRecord path;
  std::vector<ObjectRef> objects;  ///< by vertex of `path`
  /// By light of `path`: of the objects between it and the vertex the first that lets the least
  /// light through, if any light is missing.
  std::vector<std::optional<ObjectRef>> occluders;
  std::array<float, 3> picture{};  ///< linear, as stored in the image by render_path()
  /// Of its luminance, assuming independent samples; infinite with one sample, whose noise is
  /// unknown.
  double standard_error = 0;
};

/// Takes the samples of pixel (x, y) as render_path() does. `sample` selects the sample to describe
/// in full; by default, or if there is no such sample, the one nearest to the center of the pixel.
/// `pixel` is complete if the result is.
RenderStatus explain_path(const RenderScene& scene, const Assets& assets,
                          const RenderOptions& options, int x, int y,
                          std::optional<std::uint32_t> sample, PathPixel& pixel);

}  // namespace scenefile
