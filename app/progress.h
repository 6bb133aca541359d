#pragma once

#include <chrono>

namespace scenefile::app {

/// A progress line on the terminal with the estimated remaining time, removed by the destructor.
/// Rate-limited.
class ProgressBar {
 public:
  explicit ProgressBar(bool shown) : shown_(shown), start_(Clock::now()) {}
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void update(double done);

 private:
  using Clock = std::chrono::steady_clock;

  bool shown_;
  bool drawn_ = false;
  Clock::time_point start_;
  Clock::time_point last_;
};

}  // namespace scenefile::app
