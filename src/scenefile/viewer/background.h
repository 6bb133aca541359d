#pragma once
// A task that runs on another thread and is polled for its result.

#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <utility>

namespace scenefile::viewer {

/// If no thread can be started, the work is done when the result is requested.
template <typename Result>
class Background {
 public:
  bool busy() const { return future_.valid(); }

  /// Must not be called while busy(). `wake` is called on the other thread after the work.
  void start(std::function<Result()> work, std::function<void()> wake = {}) {
    future_ = std::async(std::launch::async | std::launch::deferred,
                         [work = std::move(work), wake = std::move(wake)] {
                           Result result = work();
                           if (wake) {
                             wake();
                           }
                           return result;
                         });
  }

  /// Returns the result, once; nullopt if it is not ready, unless `wait`. Rethrows std::bad_alloc.
  std::optional<Result> take(bool wait = false) {
    if (!future_.valid()) {
      return std::nullopt;
    }
    if (!wait && future_.wait_for(std::chrono::seconds(0)) == std::future_status::timeout) {
      return std::nullopt;
    }
    return future_.get();
  }

 private:
  std::future<Result> future_;
};

}  // namespace scenefile::viewer
