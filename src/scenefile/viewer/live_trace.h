#pragma once
// The ray tracer at work behind a window: pictures on the way, from a thread of its own, given up
// as soon as something else is asked for.

#include "scenefile/trace/render.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace scenefile::viewer {

/// A picture on its way.
struct TracedPicture {
  Image image;
  double done = 0;        ///< share of the work, in [0, 1]
  bool complete = false;  ///< the last one
  double seconds = 0;     ///< wall time since the start
  std::string failed;     ///< why there is none, one line; empty: there is
};

/// Used by one thread.
class LiveTrace {
 public:
  LiveTrace();
  /// Waits for the thread.
  ~LiveTrace();
  LiveTrace(const LiveTrace&) = delete;
  LiveTrace& operator=(const LiveTrace&) = delete;

  /// Starts afresh; what was under way is given up. `keep` owns `assets`. `wake` is called from
  /// another thread whenever take() has something.
  void start(RenderScene scene, std::shared_ptr<const void> keep, const Assets& assets,
             const RenderOptions& options, std::function<void()> wake);

  /// Gives up what is under way; its pictures are not seen any more. Does not wait.
  void stop();

  /// Whether pictures are to be expected.
  bool busy() const;

  /// The newest picture, if there is one that was not taken before.
  std::optional<TracedPicture> take();

 private:
  struct Job;
  class Worker;
  std::shared_ptr<Job> job_;  ///< the one whose pictures count
  std::unique_ptr<Worker> worker_;
};

}  // namespace scenefile::viewer
