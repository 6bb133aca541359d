// The only file that knows TBB.

#include "scenefile/trace/tiles.h"

#include "scenefile/trace/hand_over.h"
#include "scenefile/trace/no_denormals.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/scalable_allocator.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>

namespace scenefile {

namespace {

constexpr auto between_calls = std::chrono::milliseconds(20);

// Calls work(i) for 0 to count - 1 from all threads.
template <typename Work>
void for_each_index(std::size_t count, const Work& work) {
  const auto threads =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  tbb::task_arena arena(static_cast<int>(threads));
  const auto piece = [&work](std::size_t i) {
    const HandOver hand_over;
    const NoDenormals no_denormals;
    work(i);
  };
  HandOver::give();
  arena.execute([&] { tbb::parallel_for(std::size_t(0), count, piece); });
  HandOver::collect();
}

// TBB gets to know the thread that asks for work. Where memory runs out in that, it counts the
// thread in but never out, and the end of a global_control waits for ever: so none may live yet.
void join_tbb() {
  // Names its allocator, so that it comes with the program: else TBB opens it now, and where memory
  // runs out in that, dlopen of glibc 2.36 crashes.
  scalable_free(nullptr);
  tbb::parallel_for(0, 1, [](int) {});
}

}  // namespace

struct ThreadLimit::State {
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads) {
  join_tbb();
  if (threads > 0) {
    state_.reset(new State{
        {tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)}});
  }
}

ThreadLimit::~ThreadLimit() = default;

struct Watch::State {
  const Progress& progress;
  std::mutex mutex;
  std::atomic<bool> stop{false};
  std::atomic<double> done{0};
  std::atomic<std::chrono::steady_clock::rep> last_call{0};
};

Watch::Watch(const Progress& progress) : state_(new State{progress, {}, {}, {}, {}}) {}

Watch::~Watch() = default;

bool Watch::stopped() const {
  return state_->stop.load(std::memory_order_relaxed);
}

void Watch::count(double share) {
  State& s = *state_;
  double done = s.done.load(std::memory_order_relaxed);
  while (!s.done.compare_exchange_weak(done, done + share, std::memory_order_relaxed)) {
  }
}

bool Watch::advance(double share) {
  State& s = *state_;
  count(share);
  if (!s.progress || stopped()) {
    return !stopped();
  }
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  const auto pause = std::chrono::duration_cast<std::chrono::steady_clock::duration>(between_calls);
  if (now - s.last_call.load(std::memory_order_relaxed) < pause.count() || !s.mutex.try_lock()) {
    return !stopped();
  }
  const std::lock_guard lock(s.mutex, std::adopt_lock);
  s.last_call.store(now, std::memory_order_relaxed);
  if (!s.progress(std::min(1.0, s.done.load(std::memory_order_relaxed)))) {
    s.stop.store(true, std::memory_order_relaxed);
  }
  return !stopped();
}

void for_each_piece(Pieces& pieces, PassShare share, Watch& watch,
                    const std::function<bool(const Tile&)>& work) {
  const int width = pieces.width();
  const int height = pieces.height();
  const int columns = tiles_across(width);
  const double pixel_share = (share.end - share.begin) / (double(width) * height);
  for_each_index(pieces.count(), [&](std::size_t index) {
    const int x0 = static_cast<int>(index % columns) * tile_side;
    const int y0 = static_cast<int>(index / columns) * tile_side;
    const Tile tile{x0, y0, std::min(width, x0 + tile_side), std::min(height, y0 + tile_side)};
    const double done = pixel_share * (tile.x1 - tile.x0) * (tile.y1 - tile.y0);
    if (pieces.done(index)) {
      watch.count(done);
      return;
    }
    if (!watch.stopped() && work(tile)) {
      pieces.finish(index);
    }
    watch.advance(done);
  });
}

void for_each_line(int count, const std::function<void(int)>& work) {
  for_each_index(static_cast<std::size_t>(count),
                 [&](std::size_t line) { work(static_cast<int>(line)); });
}

}  // namespace scenefile
