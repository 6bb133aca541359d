#pragma once
// A picture as work for several threads.

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

/// Share of all work that a pass over the picture is.
struct PassShare {
  double begin = 0;
  double end = 1;
};

/// Tells the progress function how far the work is, from one thread at a time, and remembers when
/// it said to stop.
class Watch {
 public:
  explicit Watch(const Progress& progress);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Counts a share of the work as done.
  void count(double share);
  /// The same, and calls the progress function when it is time. False: stop.
  bool advance(double share);
  bool stopped() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Calls `work` for the pieces that are not done, until all are or the watch says stop; it returns
/// whether it finished its piece. Each thread computes with denormal numbers taken as zero.
void for_each_piece(Pieces& pieces, PassShare share, Watch& watch,
                    const std::function<bool(const Tile&)>& work);

/// Calls `work` for 0 to count - 1 from all threads.
void for_each_line(int count, const std::function<void(int)>& work);

}  // namespace scenefile
