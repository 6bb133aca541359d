// The examples in the pages must be the programs and projects that the tests build.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace {

std::string read(const std::string& path) {
  std::ifstream file(std::string(SCENEFILE_ROOT "/") + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Whether the page shows the whole file.
void expect_shown(const char* page, const char* file, const std::string& language = "cpp") {
  const std::string text = read(file);
  ASSERT_FALSE(text.empty()) << file;
  EXPECT_NE(read(page).find("```" + language + "\n" + text + "```"), std::string::npos) << page;
}

TEST(Examples, AreWhatTheTestsBuild) {
  expect_shown("README.md", "tests/consumer/main.cpp");
  expect_shown("docs/library.md", "tests/consumer/normals.cpp");
  expect_shown("docs/library.md", "tests/consumer/reader/CMakeLists.txt", "cmake");
  expect_shown("docs/library.md", "tests/consumer/reader/mine.cpp");
}

}  // namespace
