#pragma once
// The CPU ray tracer: render scene and assets to image. Semantics and their sources:
// docs/rendering.md.

#include "scenefile/asset/image.h"
#include "scenefile/asset/load_assets.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/trace/render_options.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace scenefile {

struct RenderStats {
  std::uint64_t primary_rays = 0;
  std::uint64_t shadow_rays = 0;
  std::uint64_t secondary_rays = 0;  ///< reflected and refracted rays
  double build_seconds = 0;          ///< wall time of building the acceleration structure
  double trace_seconds = 0;          ///< wall time of tracing
};

enum class RenderStatus : std::uint8_t {
  complete,
  cancelled,      ///< by the progress function; the image is partial
  limit_reached,  ///< instances are nested deeper than the tracer supports
  failed,         ///< the acceleration structure could not be built (out of memory)
};

struct RenderResult {
  Image image;
  std::vector<ImageLayer> layers;  ///< like RenderOptions::layers
  RenderStatus status = RenderStatus::complete;
  RenderStats stats;
};

/// Called occasionally, by one thread at a time, with the finished fraction of the picture in [0,
/// 1]. Returns false to cancel.
using Progress = std::function<bool(double done)>;

/// Intermediate pictures for display.
struct Preview {
  /// Called like Progress, with the picture so far: first one color per block of pixels, then
  /// pixels, then refined ones, and finally the result.
  std::function<void(const Image& image)> show;
  double interval_seconds = 2;  ///< minimum time between calls
};

class TraceScene;

/// Optional arguments of render().
struct RenderControl {
  Progress progress = {};
  Preview preview = {};
  /// A black image to draw into, used if it has the right size; for callers with cheaper memory
  /// than the allocator's (io/memory.h).
  Image canvas = {};
  /// A structure built before for the same scene and assets (trace_scene.h); null: render() builds
  /// it. If set, the groups of the scene are not used and may be empty.
  const TraceScene* traced = nullptr;
};

/// Renders the scene. The picture only depends on scene, assets and options: the result is the same
/// for any number of threads. `assets` must be those of this scene. For more control over the
/// process, see film.h.
RenderResult render(const RenderScene& scene, const Assets& assets, const RenderOptions& options,
                    RenderControl control = {});

}  // namespace scenefile
