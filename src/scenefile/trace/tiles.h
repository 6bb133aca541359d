#pragma once
// Divides a picture into work for several threads.

#include "scenefile/trace/pieces.h"
#include "scenefile/trace/render.h"
#include "scenefile/trace/tasks.h"

#include <functional>
#include <memory>

namespace scenefile {

/// Part of a picture: x0 <= x < x1, y0 <= y < y1.
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
class Watch {
 public:
  explicit Watch(const Progress& progress);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Adds a fraction of the work as done.
  void count(double share);
  /// The same, and calls the progress function if it is due. Returns false to stop.
  bool advance(double share);
  bool stopped() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Calls `work` for unfinished pieces until all are done or the watch stops it; `work` returns
/// whether it finished its piece. Each thread treats denormal numbers as zero.
void for_each_piece(Pieces& pieces, PassShare share, Watch& watch,
                    const std::function<bool(const Tile&)>& work);

/// Calls `work` for 0 to count - 1 from all threads.
void for_each_line(int count, const std::function<void(int)>& work);

}  // namespace scenefile
