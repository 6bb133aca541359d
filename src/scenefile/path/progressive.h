#pragma once
// Mode path for windows: a first coarse picture soon, then better and better ones.

#include "scenefile/asset/image.h"
#include "scenefile/trace/render.h"
#include "scenefile/trace/trace_scene.h"

#include <cstdint>
#include <functional>

namespace scenefile {

/// An intermediate or final picture.
struct PathPass {
  Image image;                ///< linear; smaller than the picture while `samples` is 0
  std::uint32_t samples = 0;  ///< of each pixel; 0: only some pixels have one
  /// The mean over the pixels of the standard error of their luminance as shown, by course_tone();
  /// 1 is white. From variances_of(); 0 if there are fewer than 2 samples.
  double noise = 0;
  bool complete = false;  ///< the last one
};

struct PathPasses {
  double noise = 0;  ///< complete at this noise; 0: only after options.samples
  /// Samples per second, as far as they are known from an earlier picture; 0: unknown.
  double rate = 0;
  /// Called often, from one thread at a time; `first`: there is no picture yet. False: stop.
  std::function<bool(bool first)> go_on;
  std::function<void(PathPass pass)> show;
};

/// Takes samples until the picture is complete. The first picture has one sample of every n-th
/// pixel of every n-th row, and takes about 0.1 s; the next ones have one of more pixels, and then
/// one of all, and so on. A picture with N samples has the same bytes as that of render_path() with
/// N samples. Sets passes.rate. `traced` must be of the scene. Layers and denoising are ignored.
RenderStatus render_progressively(const TraceScene& traced, const RenderScene& scene,
                                  const RenderOptions& options, PathPasses& passes);

}  // namespace scenefile
