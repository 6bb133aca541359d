#pragma once

#include <chrono>

namespace scenefile::app {

/// A line on the terminal that says how much is done and how long the rest will take; it goes away
/// with the object. Rate-limited.
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
