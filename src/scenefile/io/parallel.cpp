#include "scenefile/io/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace scenefile {

namespace {

class Queue {
 public:
  Queue(std::size_t count, const std::function<void(std::size_t)>& work)
      : count_(count), work_(work) {}

  void run() noexcept {
    try {
      for (std::size_t i = next_++; i < count_; i = next_++) {
        work_(i);
      }
    } catch (...) {
      next_ = count_;
      const std::lock_guard lock(mutex_);
      thrown_ = std::current_exception();
    }
  }

  void rethrow() const {
    if (thrown_) {
      std::rethrow_exception(thrown_);
    }
  }

 private:
  std::size_t count_;
  const std::function<void(std::size_t)>& work_;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::exception_ptr thrown_;
};

}  // namespace

int thread_count(int wanted) {
  return wanted > 0 ? wanted : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

void for_each_index(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  const auto most = static_cast<std::size_t>(thread_count(threads));
  Queue queue(count, work);
  std::vector<std::thread> helpers;
  try {
    while (helpers.size() + 1 < std::min(count, most)) {
      helpers.emplace_back([&queue] { queue.run(); });
    }
  } catch (const std::exception&) {
    // No more threads are available: those that run do all the work.
  }
  queue.run();
  for (std::thread& helper : helpers) {
    helper.join();
  }
  queue.rethrow();
}

void lower_thread_priority() {
#ifdef __linux__
  constexpr int lower = 5;
  ::setpriority(PRIO_PROCESS, 0, ::getpriority(PRIO_PROCESS, 0) + lower);  // 0: this thread
#endif
}

}  // namespace scenefile
