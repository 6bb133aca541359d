#pragma once
// Work on independent indices by several threads.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace scenefile {

/// Calls `work_on(i)` for each i in [start, end), in any order, by at most `threads` threads (0:
/// one for each processor), and no more than eight.
template <typename F>
void in_parallel(std::size_t start, std::size_t end, int threads, const F& work_on) {
  const unsigned wanted =
      threads > 0 ? static_cast<unsigned>(threads) : std::thread::hardware_concurrency();
  std::atomic<std::size_t> next = start;
  const auto work = [&] {
    for (std::size_t i = next++; i < end; i = next++) {
      work_on(i);
    }
  };
  std::vector<std::future<void>> others;
  for (std::size_t i = 1; i < std::min<std::size_t>({wanted, 8, end - start}); ++i) {
    others.push_back(std::async(std::launch::async, work));
  }
  work();
  for (std::future<void>& other : others) {
    other.get();
  }
}

}  // namespace scenefile
