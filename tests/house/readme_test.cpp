// The examples in the pages must be the programs that the tests build against the installed
// package.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace {

std::string read(const std::string& path) {
  std::ifstream file(std::string(SCENEFILE_ROOT "/") + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Whether the page shows the whole program.
void expect_shown(const char* page, const char* program) {
  const std::string text = read(program);
  ASSERT_FALSE(text.empty()) << program;
  EXPECT_NE(read(page).find("```cpp\n" + text + "```"), std::string::npos) << page;
}

TEST(Examples, AreTheConsumersOfTheInstalledPackage) {
  expect_shown("README.md", "tests/consumer/main.cpp");
  expect_shown("docs/library.md", "tests/consumer/normals.cpp");
}

}  // namespace
