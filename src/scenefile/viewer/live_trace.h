#pragma once
// Progressive tracing for a window: intermediate pictures from another thread, canceled as soon as
// something else is requested.

#include "scenefile/trace/render.h"
#include "scenefile/viewer/picker.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace scenefile::viewer {

/// Path tracing ends at this noise, unless a number of samples is given.
inline constexpr double path_noise = 0.01;
/// The most samples per pixel that path tracing takes to get there.
inline constexpr int most_path_samples = 4096;

/// A picture to trace.
struct TraceRequest {
  RenderScene scene;
  std::shared_ptr<const void> keep;  ///< owns `assets`
  const Assets* assets = nullptr;
  /// What `scene` lacks of the scene of `keep`. In mode path, pictures with equal `keep` and
  /// `hidden` share an acceleration structure.
  Hidden hidden;
  RenderOptions options;  ///< in mode path, `samples` is the maximum
  double noise = 0;       ///< PathPasses::noise
  /// Called from another thread whenever take() has a new picture.
  std::function<void()> wake;
};

/// An intermediate or final picture.
struct TracedPicture {
  Texture picture;        ///< first pictures of mode path are smaller than requested
  double done = 0;        ///< fraction of the work, in [0, 1]; not in mode path
  bool complete = false;  ///< the last one
  double seconds = 0;     ///< wall time since the start
  std::string failed;     ///< an error in one line; empty: success
  /// Mode path: of each pixel; 0 while not all pixels have one. The picture has the bytes that
  /// render_path() and tone_mapped() give for this number.
  int samples = 0;
  double noise = 0;  ///< PathPass::noise
  Image linear{};    ///< if complete: the values before they are tone-mapped and made 8-bit
};

/// Must be used from one thread.
class LiveTrace {
 public:
  LiveTrace();
  /// Waits for the thread to end.
  ~LiveTrace();
  LiveTrace(const LiveTrace&) = delete;
  LiveTrace& operator=(const LiveTrace&) = delete;

  /// Cancels current work and starts again. The first, coarse picture of canceled mode path work is
  /// still delivered, so that there are pictures while the camera moves.
  void start(TraceRequest request);

  /// Cancels current work and discards its pictures. Does not wait.
  void stop();

  /// Whether more pictures of the current work will come.
  bool busy() const;

  /// The newest picture that was not taken yet, if any.
  std::optional<TracedPicture> take();

 private:
  struct Job;
  class Worker;
  std::shared_ptr<Job> job_;     ///< the current one
  std::shared_ptr<Job> before_;  ///< replaced by it
  std::unique_ptr<Worker> worker_;
};

}  // namespace scenefile::viewer
