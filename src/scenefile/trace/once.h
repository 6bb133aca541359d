#pragma once
// Work that is done at first use, from whichever thread needs it.

#include <atomic>
#include <mutex>

namespace scenefile {

/// Like std::once_flag and std::call_once. Those pass exceptions through pthread_once, for which
/// glibc loads libgcc_s: where memory has run out that ends the process instead.
class Once {
 public:
  /// Calls `work` unless an earlier call has finished it. If `work` throws, the next call tries
  /// again.
  template <typename Work>
  void operator()(const Work& work) {
    if (done_.load(std::memory_order_acquire)) {
      return;
    }
    const std::lock_guard lock(mutex_);
    if (!done_.load(std::memory_order_relaxed)) {
      work();
      done_.store(true, std::memory_order_release);
    }
  }

 private:
  std::atomic<bool> done_{false};
  std::mutex mutex_;
};

}  // namespace scenefile
