#pragma once
// Parallel loops: with oneTBB (tbb_tasks.cpp), or without threads (serial_tasks.cpp), depending on
// the build.

#include <cstddef>
#include <functional>
#include <memory>

namespace scenefile {

/// Limits the number of threads for all parallel work of the process during its lifetime, including
/// Embree's; 0: one per processor. If there are several, the smallest limit applies.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Calls `work` for 0 to count - 1 from all threads, which treat denormal numbers as zero.
void for_each_task(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace scenefile
