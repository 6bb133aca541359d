// The README's example must be the program that the tests build against the installed package.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace {

std::string read(const std::string& path) {
  std::ifstream file(std::string(SCENEFILE_ROOT "/") + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Readme, ShowsTheConsumer) {
  const std::string consumer = read("tests/consumer/main.cpp");
  ASSERT_FALSE(consumer.empty());
  EXPECT_NE(read("README.md").find("```cpp\n" + consumer + "```"), std::string::npos);
}

}  // namespace
