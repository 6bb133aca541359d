#pragma once
// Divides a picture into work for several threads.

#include "scenefile/trace/render.h"
#include "scenefile/trace/tasks.h"
#include "scenefile/trace/tile_flags.h"

#include <functional>
#include <memory>

namespace scenefile {

/// A rectangle of pixels: x0 <= x < x1, y0 <= y < y1.
struct Tile {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
};

/// The range of the total work that a pass covers.
struct PassShare {
  double begin = 0;
  double end = 1;
};

/// Reports progress, from one thread at a time, and remembers when the progress function cancels.
class ProgressMonitor {
 public:
  explicit ProgressMonitor(const Progress& progress);
  ~ProgressMonitor();
  ProgressMonitor(const ProgressMonitor&) = delete;
  ProgressMonitor& operator=(const ProgressMonitor&) = delete;

  /// Adds a fraction of the work as done.
  void count(double share);
  /// The same, and calls the progress function if it is due. Returns false to stop.
  bool advance(double share);
  bool stopped() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Calls `work` for unfinished tiles until all are done or the monitor stops it; `work` returns
/// whether it finished its tile. Each thread treats denormal numbers as zero.
void for_each_unfinished_tile(TileFlags& tiles, PassShare share, ProgressMonitor& monitor,
                              const std::function<bool(const Tile&)>& work);

/// Calls `work` for 0 to count - 1 from all threads.
void for_each_line(int count, const std::function<void(int)>& work);

}  // namespace scenefile
