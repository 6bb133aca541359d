#pragma once
// One piece of work in a thread of its own, asked about now and then.

#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <utility>

namespace scenefile::viewer {

/// Where no thread can be had the work is done when it is asked for.
template <typename Result>
class Background {
 public:
  bool busy() const { return future_.valid(); }

  /// Not while busy.
  void start(std::function<Result()> work) {
    future_ = std::async(std::launch::async | std::launch::deferred, std::move(work));
  }

  /// The result, once. Waits for it where `wait` says so. Rethrows std::bad_alloc.
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
