#pragma once
// Progressive ray tracing for a window: intermediate pictures from another thread, canceled as soon
// as something else is requested.

#include "scenefile/trace/render.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace scenefile::viewer {

/// An intermediate or final picture.
struct TracedPicture {
  Texture picture;
  double done = 0;        ///< fraction of the work, in [0, 1]
  bool complete = false;  ///< the last one
  double seconds = 0;     ///< wall time since the start
  std::string failed;     ///< an error in one line; empty: success
};

/// Must be used from one thread.
class LiveTrace {
 public:
  LiveTrace();
  /// Waits for the thread to end.
  ~LiveTrace();
  LiveTrace(const LiveTrace&) = delete;
  LiveTrace& operator=(const LiveTrace&) = delete;

  /// Cancels current work and starts again. `keep` owns `assets`. `wake` is called from another
  /// thread whenever take() has a new picture.
  void start(RenderScene scene, std::shared_ptr<const void> keep, const Assets& assets,
             const RenderOptions& options, std::function<void()> wake);

  /// Cancels current work and discards its pictures. Does not wait.
  void stop();

  /// Whether more pictures will come.
  bool busy() const;

  /// The newest picture that was not taken yet, if any.
  std::optional<TracedPicture> take();

 private:
  struct Job;
  class Worker;
  std::shared_ptr<Job> job_;  ///< the current one
  std::unique_ptr<Worker> worker_;
};

}  // namespace scenefile::viewer
