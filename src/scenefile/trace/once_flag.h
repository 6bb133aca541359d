#pragma once
// Lazy initialization from any thread.

#include <atomic>
#include <mutex>

namespace scenefile {

/// Like std::once_flag and std::call_once, but without pthread_once, for which glibc loads libgcc_s
/// to propagate exceptions; if memory has run out, that would abort the process.
class OnceFlag {
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
