#pragma once

#include <atomic>

namespace scenefile {

/// What TBB sees to between the thread that gives work and those that do it, said once more in
/// atomics: ThreadSanitizer cannot look into TBB and would take all data that is handed over for
/// races. They order nothing between two pieces of the work, so that races there are found.
/// Global, because a thread that has taken nothing yet may read nothing.
struct HandOver {
  /// Before work is given to other threads, and after all of it is done.
  static void give() { given.fetch_add(1, std::memory_order_release); }
  static void collect() { static_cast<void>(done.load(std::memory_order_acquire)); }

  /// While it lives, a piece of the work is done.
  HandOver() { static_cast<void>(given.load(std::memory_order_acquire)); }
  ~HandOver() { done.fetch_add(1, std::memory_order_release); }
  HandOver(const HandOver&) = delete;
  HandOver& operator=(const HandOver&) = delete;

 private:
  static inline std::atomic<unsigned> given{0};
  static inline std::atomic<unsigned> done{0};
};

}  // namespace scenefile
