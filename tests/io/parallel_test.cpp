#include "scenefile/io/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <set>
#include <thread>
#include <vector>

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace scenefile {
namespace {

TEST(ForEachIndex, CallsEachOnce) {
  for (const int threads : {0, 1, 2, 7}) {
    for (const std::size_t count : {0u, 1u, 2u, 100u}) {
      std::vector<std::atomic<int>> calls(count);
      for_each_index(count, threads, [&](std::size_t i) { ++calls[i]; });
      for (const std::atomic<int>& times : calls) {
        EXPECT_EQ(times, 1) << threads << " threads, " << count;
      }
    }
  }
}

TEST(ForEachIndex, TwoWaitForEachOther) {
  std::atomic<int> here{0};
  for_each_index(2, 2, [&](std::size_t) {
    ++here;
    while (here < 2) {
      std::this_thread::yield();
    }
  });
  EXPECT_EQ(here, 2);
}

TEST(ForEachIndex, OneThreadIsTheCallers) {
  std::set<std::thread::id> threads;
  for_each_index(5, 1, [&](std::size_t) { threads.insert(std::this_thread::get_id()); });
  EXPECT_EQ(threads, std::set{std::this_thread::get_id()});
}

TEST(ForEachIndex, ExceptionsReachTheCaller) {
  const auto fail = [](std::size_t i) {
    if (i == 3) {
      throw std::bad_alloc();
    }
  };
  EXPECT_THROW(for_each_index(10, 4, fail), std::bad_alloc);
  EXPECT_THROW(for_each_index(10, 1, fail), std::bad_alloc);
}

#ifdef __linux__
TEST(LowerThreadPriority, OnlyOfTheThreadAndThoseThatItStarts) {
  const auto priority = [] { return ::getpriority(PRIO_PROCESS, 0); };
  const int ours = priority();
  int lowered = 0;
  int of_child = 0;
  std::thread([&] {
    lower_thread_priority();
    lowered = priority();
    std::thread([&] { of_child = priority(); }).join();
  }).join();
  EXPECT_GT(lowered, ours);
  EXPECT_EQ(of_child, lowered);
  EXPECT_EQ(priority(), ours);
}
#endif

}  // namespace
}  // namespace scenefile
