#pragma once
// The path tracer: light by paths from the camera, for scenes whose faces emit light as well as for
// scenes with lights. Equations and conventions: docs/path.md.

#include "scenefile/path/path_state.h"

namespace scenefile {

/// Optional arguments of render_path().
struct PathControl {
  Progress progress = {};
  /// Stops before the next pass if it would end later than this after the call; 0: no limit. There
  /// is at least one sample per pixel.
  double seconds = 0;
  /// A structure built before for the same scene and assets; null: render_path() builds it.
  const TraceScene* traced = nullptr;
};

/// The image is linear, and denoised if options.denoise; layers that mode path does not have are 0.
struct PathResult : RenderResult {
  PathState state;
  std::uint32_t samples = 0;  ///< per pixel; if cancelled the fewest
};

/// Renders the scene with options.samples per pixel, fewer if the time is over; all else as
/// render(). The picture only depends on scene, assets, options and the number of samples.
PathResult render_path(const RenderScene& scene, const Assets& assets, const RenderOptions& options,
                       const PathControl& control = {});

}  // namespace scenefile
