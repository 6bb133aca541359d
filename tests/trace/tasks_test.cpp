#include "scenefile/trace/tasks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace scenefile {
namespace {

// Whether two tasks of one loop run at the same time, at the latest after a while.
bool two_at_once() {
  std::atomic<int> running{0};
  std::atomic<bool> both{false};
  for_each_task(2, [&](std::size_t) {
    ++running;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!both && std::chrono::steady_clock::now() < end) {
      both = both || running == 2;
      std::this_thread::yield();
    }
    --running;
  });
  return both;
}

TEST(Tasks, ManyShortLoopsKeepTheThreads) {
  const ThreadLimit limit(2);
  for (int loop = 0; loop < 500; ++loop) {
    std::atomic<int> done{0};
    for_each_task(8, [&](std::size_t) { ++done; });
    ASSERT_EQ(done, 8);
  }
  EXPECT_TRUE(two_at_once());
}

TEST(Tasks, LoopsMayBeNested) {
  const ThreadLimit limit(2);
  std::atomic<int> done{0};
  for_each_task(20, [&](std::size_t) { for_each_task(10, [&](std::size_t) { ++done; }); });
  EXPECT_EQ(done, 200);
}

}  // namespace
}  // namespace scenefile
