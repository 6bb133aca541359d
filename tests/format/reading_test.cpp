// What the readers answer for each scene in tests/fixtures/reading: NAME.xml or NAME.json, and
// NAME.expected.txt beside it. `make accept-readings` writes the expected files again; look at
// the difference before you commit it.
//
// A line such as `--compat course` in an expected file begins the answer with these options:
// --compat course, --check (the findings of check() too), --limit NAME=N.

#include "format/reading.h"

#include "format/answer.h"
#include "scenefile/base/text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace scenefile::testing {
namespace {

namespace fs = std::filesystem;

const fs::path folder = SCENEFILE_FIXTURES "/reading";

// Paths without their folder, in the order of names.
std::vector<std::string> cases() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".xml" || entry.path().extension() == ".json") {
      names.push_back(entry.path().lexically_relative(folder).string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path expected_path(const std::string& name) {
  return (folder / name).replace_extension(".expected.txt");
}

std::string answer_with(const std::string& line_of_options, std::string_view text) {
  constexpr std::pair<std::string_view, std::uint32_t Limits::*> limits[] = {
      {"nesting=", &Limits::nesting},
      {"attributes=", &Limits::attributes},
      {"name-bytes=", &Limits::name_bytes},
      {"value-bytes=", &Limits::value_bytes},
      {"messages-per-code=", &Limits::messages_per_code}};
  ReadOptions options;
  bool checked = false;
  std::istringstream words(line_of_options);
  for (std::string word; words >> word;) {
    if (word == "--check") {
      checked = true;
      continue;
    }
    std::string value;
    words >> value;
    bool known = word == "--compat" && value == "course";
    options.compat_course |= known;
    for (const auto& [name, member] : limits) {
      if (word == "--limit" && value.starts_with(name)) {
        options.limits.*member = static_cast<std::uint32_t>(std::stoul(value.substr(name.size())));
        known = true;
      }
    }
    EXPECT_TRUE(known) << "unknown option: " << word << ' ' << value;
  }
  return answer(text, options, checked);
}

// The text that the expected file should have: with the lines of options that it has.
std::string answers(const std::string& expected, std::string_view text) {
  std::string all;
  std::istringstream lines(expected);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("--")) {
      all += (all.empty() ? "" : "\n") + line + "\n" + answer_with(line, text);
    } else if (all.empty()) {
      all = answer_with("", text);
    }
  }
  return all.empty() ? answer_with("", text) : all;
}

class Readings : public ::testing::TestWithParam<std::string> {};

TEST_P(Readings, AreAsExpected) {
  const fs::path path = expected_path(GetParam());
  const std::string expected = file_text(path);
  const std::string actual = answers(expected, file_text(folder / GetParam()));
  if (std::getenv("SCENEFILE_ACCEPT_READINGS") != nullptr && actual != expected) {
    std::ofstream(path, std::ios::binary) << actual;
    return;
  }
  EXPECT_EQ(expected, actual) << "if this is better: make accept-readings";
}

// The places count characters, whatever their bytes are.
TEST_P(Readings, AreTheSameInOtherLineEndingsAndEncodings) {
  const std::string text = file_text(folder / GetParam());
  const std::string expected = answer_with("", text);
  std::string dos;
  std::string mac;
  for (const char c : text) {
    dos += c == '\n' ? "\r\n" : std::string(1, c);
    mac += c == '\n' ? '\r' : c;
  }
  EXPECT_EQ(answer_with("", dos), expected);
  EXPECT_EQ(answer_with("", mac), expected);
  EXPECT_EQ(answer_with("", "\xEF\xBB\xBF" + text), expected);
  if (GetParam().ends_with(".json")) {
    return;
  }
  std::string utf16 = "\xFE\xFF";
  std::string latin = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>";
  const auto unit = [&](char32_t value) {
    utf16 += static_cast<char>(value >> 8);
    utf16 += static_cast<char>(value & 0xFF);
  };
  bool is_latin = true;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint c = first_code_point(std::string_view(text).substr(at));
    ASSERT_GT(c.bytes, 0u);
    at += c.bytes;
    if (c.value > 0xFFFF) {
      unit(0xD7C0 + (c.value >> 10));
      unit(0xDC00 + (c.value & 0x3FF));
    } else {
      unit(c.value);
    }
    latin += static_cast<char>(c.value);
    is_latin = is_latin && c.value < 0x100;
  }
  EXPECT_EQ(answer_with("", utf16), expected);
  if (is_latin) {
    // The declaration is before the first line, whose columns it moves.
    EXPECT_EQ(answer_with("", latin.insert(latin.find('>') + 1, "\n")),
              answer_with("", "\n" + text));
  }
}

INSTANTIATE_TEST_SUITE_P(All, Readings, ::testing::ValuesIn(cases()), [](const auto& name) {
  std::string word = name.param;
  std::replace_if(
      word.begin(), word.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return word;
});

TEST(Readings, HaveNoFileWithoutAScene) {
  const std::vector<std::string> names = cases();
  std::size_t files = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    files += entry.is_regular_file() ? 1 : 0;
  }
  EXPECT_GT(names.size(), 40u);
  EXPECT_EQ(files, 2 * names.size());
}

}  // namespace
}  // namespace scenefile::testing
