// For every code of the program: a file for which `check` reports it, and a similar one for which
// it does not: CODE.xml and CODE.ok.xml (or .json) in a folder of tests/fixtures.

#include "app/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace scenefile {

namespace {

using namespace testing_support;
namespace fs = std::filesystem;

// Codes that no scene file of reasonable size can cause in check, and where they are tested.
bool is_given_elsewhere(const std::string& code) {
  static const std::set<std::string> by_programs{
      "scene.bad-index", "scene.not-finite", "scene.shared-node", "tree.instance-with-contents"};
  // Limits are tested in their rooms, with lower limits.
  const bool limit = code.ends_with("limit");
  return limit || by_programs.contains(code);
}

// Codes of other commands, which have separate tests.
bool is_of_check(const std::string& code) {
  static const std::set<std::string> others{"config", "convert",  "export", "gl",   "import",
                                            "pov",    "realtime", "render", "write"};
  return !others.contains(code.substr(0, code.find('.')));
}

std::vector<std::string> codes_of_check() {
  const rapidjson::Document help = parse_json(run_program({"help", "--json"}).out);
  std::vector<std::string> codes;
  for (const auto& code : help["codes"].GetArray()) {
    const std::string name = code["name"].GetString();
    if (is_of_check(name) && !is_given_elsewhere(name)) {
      codes.push_back(name);
    }
  }
  return codes;
}

// The file for the code; empty if there is none.
std::string fixture(const std::string& code, const std::string& ending) {
  for (const std::string folder : {"codes", "format", "format_json"}) {
    for (const std::string syntax : {".xml", ".json"}) {
      const fs::path path = fs::path(SCENEFILE_FIXTURES) / folder / (code + ending + syntax);
      if (fs::exists(path)) {
        return path.string();
      }
    }
  }
  return {};
}

// The codes that check reports for each file.
std::map<std::string, std::set<std::string>> given(const std::vector<std::string>& files,
                                                   const std::vector<std::string>& options) {
  std::vector<std::string> words{"check", "--json"};
  words.insert(words.end(), options.begin(), options.end());
  words.insert(words.end(), files.begin(), files.end());
  const rapidjson::Document report = parse_json(run_program(words).out);
  std::map<std::string, std::set<std::string>> result;
  for (const auto& scene : report["scenes"].GetArray()) {
    std::set<std::string>& codes = result[scene["file"].GetString()];
    for (const auto& finding : scene["findings"].GetArray()) {
      codes.insert(finding["code"].GetString());
    }
  }
  return result;
}

void expect_given(const std::vector<std::string>& codes, const std::vector<std::string>& options) {
  std::vector<std::string> files;
  for (const std::string& code : codes) {
    for (const std::string ending : {"", ".ok"}) {
      files.push_back(fixture(code, ending));
      ASSERT_NE(files.back(), "") << code << " lacks a file " << code << ending << ".xml";
    }
  }
  const auto found = given(files, options);
  for (const std::string& code : codes) {
    EXPECT_TRUE(found.at(fixture(code, "")).contains(code)) << code;
    EXPECT_FALSE(found.at(fixture(code, ".ok")).contains(code)) << code;
  }
}

const std::string of_compat = "xml.after-object-used";

TEST(Codes, EachIsTriggeredByAFileAndNotByASimilarOne) {
  std::vector<std::string> codes = codes_of_check();
  std::erase(codes, of_compat);
  EXPECT_GE(codes.size(), 140u);
  expect_given(codes, {});
}

TEST(Codes, CodesOfCompatCourse) {
  expect_given({of_compat}, {"--compat", "course"});
}

TEST(Codes, EachFileBelongsToAnExistingCode) {
  const std::vector<std::string> codes = codes_of_check();
  for (const auto& entry : fs::directory_iterator(SCENEFILE_FIXTURES "/codes")) {
    std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".xml" && entry.path().extension() != ".json") {
      continue;
    }
    if (name.ends_with(".ok")) {
      name.resize(name.size() - 3);
    }
    EXPECT_NE(std::find(codes.begin(), codes.end(), name), codes.end()) << entry.path();
  }
}

// The similar files have no findings at all.
TEST(Codes, SimilarFilesHaveNoFindings) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(SCENEFILE_FIXTURES "/codes")) {
    const std::string extension = entry.path().extension();
    if (entry.path().stem().string().ends_with(".ok") &&
        (extension == ".xml" || extension == ".json")) {
      files.push_back(entry.path().string());
    }
  }
  for (const auto& [file, codes] : given(files, {})) {
    EXPECT_TRUE(codes.empty()) << file << ": " << *codes.begin();
  }
}

}  // namespace

}  // namespace scenefile
