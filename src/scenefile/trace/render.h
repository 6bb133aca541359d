#pragma once
// The CPU ray tracer: ready scene + assets -> image. Semantics and their sources:
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
  std::uint64_t secondary_rays = 0;  ///< reflected and refracted
  double build_seconds = 0;          ///< wall time of building the acceleration structure
  double trace_seconds = 0;          ///< wall time of tracing
};

enum class RenderStatus : std::uint8_t {
  complete,
  cancelled,      ///< the progress function said so; the image is partial
  limit_reached,  ///< the scene nests instances deeper than the tracer can follow
  failed,         ///< the acceleration structure could not be built (out of memory)
  not_resumed,    ///< Checkpoints::resume is no state of such a picture; nothing was done
};

struct RenderResult {
  Image image;
  std::vector<ImageLayer> layers;  ///< as RenderOptions::layers
  RenderStatus status = RenderStatus::complete;
  RenderStats stats;
};

/// Called now and then, from any one thread at a time, with the share of the picture that is done
/// in [0, 1]. Returns false to stop.
using Progress = std::function<bool(double done)>;

/// For renders that something may cut short.
struct Checkpoints {
  /// A state that `save` was given; empty: from the start. It must be of the same scene, assets,
  /// options and build: nothing here can tell.
  std::string resume;
  /// Called as Progress is, with the state of the work, whenever `interval_seconds` have passed
  /// since the last time, and when Progress says to stop.
  std::function<void(const std::string& state)> save;
  double interval_seconds = 4;
};

/// Pictures on the way, for someone who waits.
struct Preview {
  /// Called as Progress is, with the picture as far as it is: first one color for each block of
  /// pixels, then pixels, then better ones, in the end the result.
  std::function<void(const Image& image)> show;
  double interval_seconds = 2;  ///< at least, between calls
};

class TraceScene;

/// What render() may be given besides; all of it may be left out.
struct RenderControl {
  Progress progress = {};
  Checkpoints checkpoints = {};
  Preview preview = {};
  /// A black image in which to draw the picture, if it has the same size; for those who know
  /// cheaper memory than the allocator does (io/memory.h).
  Image canvas = {};
  /// Of the same scene and assets, built before (trace_scene.h); null: render() builds what it
  /// needs. With it the groups of the scene are not looked at and may be empty.
  const TraceScene* traced = nullptr;
};

/// Renders. The picture is a function of scene, assets and options alone: any number of threads
/// gives the same bytes, whether the work was resumed or not (statistics are of this run alone).
/// `assets` must have been loaded for this scene. Who wants more say in the course of the work:
/// picture_state.h.
RenderResult render(const RenderScene& scene, const Assets& assets, const RenderOptions& options,
                    RenderControl control = {});

}  // namespace scenefile
