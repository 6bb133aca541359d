#pragma once

#include <atomic>

namespace scenefile {

/// Repeats the synchronization that TBB does between the thread that submits work and the workers,
/// with atomics: TBB is not instrumented for ThreadSanitizer, which would otherwise report all data
/// passed this way as races. Two pieces of work are not ordered by this, so that races between them
/// are found. Global, because a thread without work must not read anything else.
struct TsanHandoff {
  /// Called before work is submitted, and after all of it is done.
  static void give() { given.fetch_add(1, std::memory_order_release); }
  static void collect() { static_cast<void>(done.load(std::memory_order_acquire)); }

  /// An object of this class exists while a piece of work runs.
  TsanHandoff() { static_cast<void>(given.load(std::memory_order_acquire)); }
  ~TsanHandoff() { done.fetch_add(1, std::memory_order_release); }
  TsanHandoff(const TsanHandoff&) = delete;
  TsanHandoff& operator=(const TsanHandoff&) = delete;

 private:
  static inline std::atomic<unsigned> given{0};
  static inline std::atomic<unsigned> done{0};
};

}  // namespace scenefile
