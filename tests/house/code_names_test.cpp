// Checks that the constants of codes match their printed names, and that the rooms' lists of codes
// are complete.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path root = SCENEFILE_ROOT;

struct Constant {
  std::string identifier;  ///< camera_up_zero
  std::string name;        ///< camera.up-zero
  fs::path header;
};

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> sources(const std::string& extension) {
  std::vector<fs::path> paths;
  for (const char* const folder : {"src/scenefile", "app"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() == extension) {
        paths.push_back(entry.path());
      }
    }
  }
  return paths;
}

std::vector<Constant> constants() {
  const std::regex pattern(R"re(constexpr\s+Code\s+(\w+)\s*\{\s*"([^"]+)")re");
  std::vector<Constant> result;
  for (const fs::path& header : sources(".h")) {
    const std::string text = text_of(header);
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
      result.push_back({(*it)[1], (*it)[2], fs::relative(header, root)});
    }
  }
  return result;
}

TEST(CodeNames, AreThoseOfTheirConstants) {
  const std::vector<Constant> all = constants();
  EXPECT_GT(all.size(), 150u);
  for (const Constant& constant : all) {
    std::string wanted = constant.name;
    std::replace_if(
        wanted.begin(), wanted.end(), [](char c) { return c == '.' || c == '-'; }, '_');
    EXPECT_EQ(constant.identifier, wanted) << constant.header;
  }
}

TEST(CodeNames, AreAllListed) {
  const std::regex pattern(R"(&(\w+)\s*[,}])");
  std::set<std::string> listed;
  for (const fs::path& source : sources(".cpp")) {
    const std::string text = text_of(source);
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
      listed.insert((*it)[1]);
    }
  }
  for (const Constant& constant : constants()) {
    EXPECT_TRUE(listed.contains(constant.identifier))
        << constant.identifier << " of " << constant.header << " is in no list of codes";
  }
}

}  // namespace
