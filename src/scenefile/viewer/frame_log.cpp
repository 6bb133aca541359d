#include "scenefile/viewer/frame_log.h"

#include <fmt/format.h>

#include <chrono>
#include <ctime>

namespace scenefile::viewer {

namespace {

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

FrameLog::FrameLog() : start_(wall_seconds()) {}

void FrameLog::begin() {
  wall_ = wall_seconds();
  cpu_ = thread_seconds();
}

void FrameLog::end(bool drawn, bool traced) {
  entries_.push_back(
      {wall_ - start_, wall_seconds() - wall_, thread_seconds() - cpu_, drawn, traced});
}

std::string FrameLog::text() const {
  std::string text = "at_ms\twall_ms\tcpu_ms\tdrawn\ttraced\n";
  for (const Entry& entry : entries_) {
    text += fmt::format("{:.1f}\t{:.2f}\t{:.2f}\t{:d}\t{:d}\n", 1e3 * entry.at, 1e3 * entry.wall,
                        1e3 * entry.cpu, entry.drawn, entry.traced);
  }
  return text;
}

}  // namespace scenefile::viewer
