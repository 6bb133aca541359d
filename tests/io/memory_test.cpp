#include "scenefile/io/memory.h"

#include "io/temp_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace scenefile {

namespace {

using testing_support::TempFolder;

constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();

TEST(MemoryLimit, ReadsControlGroupsOfVersionTwo) {
  const TempFolder root;
  root.write("a/memory.max", "max\n");
  root.write("a/b/memory.max", "5000\n");
  root.write("a/b/c/memory.max", "9000\n");
  EXPECT_EQ(cgroup_memory_limit("0::/a/b/c\n", root.path()), 5000);
  EXPECT_EQ(cgroup_memory_limit("0::/a\n", root.path()), none);
  EXPECT_EQ(cgroup_memory_limit("0::/elsewhere\n", root.path()), none);
}

TEST(MemoryLimit, ReadsControlGroupsOfVersionOne) {
  const TempFolder root;
  root.write("memory/memory.limit_in_bytes", "7000\n");
  root.write("memory/a/memory.limit_in_bytes", "8000\n");
  root.write("a/memory.limit_in_bytes", "1\n");
  const std::string groups = "5:cpu,cpuacct:/a\n4:memory:/a\n0::/\n";
  EXPECT_EQ(cgroup_memory_limit(groups, root.path()), 7000);
  EXPECT_EQ(cgroup_memory_limit("5:cpu:/a\n", root.path()), none);
}

TEST(MemoryLimit, InvalidGroupMembershipSetsNoLimit) {
  EXPECT_EQ(cgroup_memory_limit("", "/nowhere"), none);
  EXPECT_EQ(cgroup_memory_limit("::\n:\nx\n\n", "/nowhere"), none);
}

TEST(MemoryLimit, TheDefaultDependsOnTheMachine) {
  EXPECT_GT(default_memory_limit(), std::uint64_t{1} << 26);
  EXPECT_LT(default_memory_limit(), std::uint64_t{1} << 50);
}

TEST(LargePages, CanBeUsedLikeOtherMemory) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1000}, std::size_t{8} << 20}) {
    std::vector<char> bytes;
    bytes.reserve(count);
    ask_for_large_pages(bytes.data(), bytes.capacity());
    bytes.resize(count);
    EXPECT_EQ(static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), 0)), count);
  }
}

TEST(MemoryInUse, IsThatOfThisProcess) {
  EXPECT_GT(memory_in_use(), std::uint64_t{1} << 20);
  EXPECT_LT(memory_in_use(), std::uint64_t{1} << 40);
}

}  // namespace

}  // namespace scenefile
