#include "scenefile/trace/tiles.h"

#include "scenefile/trace/tasks.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>

namespace scenefile {

namespace {

constexpr auto between_calls = std::chrono::milliseconds(20);

}  // namespace

struct ProgressMonitor::State {
  const Progress& progress;
  std::mutex mutex;
  std::atomic<bool> stop{false};
  std::atomic<double> done{0};
  std::atomic<std::chrono::steady_clock::rep> last_call{0};
};

ProgressMonitor::ProgressMonitor(const Progress& progress)
    : state_(new State{progress, {}, {}, {}, {}}) {}

ProgressMonitor::~ProgressMonitor() = default;

bool ProgressMonitor::stopped() const {
  return state_->stop.load(std::memory_order_relaxed);
}

void ProgressMonitor::count(double share) {
  State& s = *state_;
  double done = s.done.load(std::memory_order_relaxed);
  while (!s.done.compare_exchange_weak(done, done + share, std::memory_order_relaxed)) {
  }
}

bool ProgressMonitor::advance(double share) {
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

void for_each_unfinished_tile(TileFlags& tiles, PassShare share, ProgressMonitor& monitor,
                              const std::function<bool(const Tile&)>& work) {
  const int width = tiles.width();
  const int height = tiles.height();
  const int columns = tiles_across(width);
  const double pixel_share = (share.end - share.begin) / (double(width) * height);
  for_each_task(tiles.count(), [&](std::size_t index) {
    const int x0 = static_cast<int>(index % columns) * tile_side;
    const int y0 = static_cast<int>(index / columns) * tile_side;
    const Tile tile{x0, y0, std::min(width, x0 + tile_side), std::min(height, y0 + tile_side)};
    const double done = pixel_share * (tile.x1 - tile.x0) * (tile.y1 - tile.y0);
    if (tiles.done(index)) {
      monitor.count(done);
      return;
    }
    if (!monitor.stopped() && work(tile)) {
      tiles.finish(index);
    }
    monitor.advance(done);
  });
}

void for_each_line(int count, const std::function<void(int)>& work) {
  for_each_task(static_cast<std::size_t>(count),
                [&](std::size_t line) { work(static_cast<int>(line)); });
}

}  // namespace scenefile
