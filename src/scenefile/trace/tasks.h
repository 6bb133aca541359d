#pragma once
// Work for several threads: by oneTBB (tbb_tasks.cpp), or all of it by the caller
// (serial_tasks.cpp), as the build has it.

#include <cstddef>
#include <functional>
#include <memory>

namespace scenefile {

/// Allows so many threads to all parallel work of the process while it lives, that of the ray
/// library included; 0: one a processor. The smallest of several counts.
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

/// Calls `work` for 0 to count - 1 from all threads. Each computes with denormal numbers taken as
/// zero.
void for_each_task(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace scenefile
