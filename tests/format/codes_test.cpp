// For every code: a file that causes it, and a similar one that does not.

#include "format/codes_of.h"
#include "format/reading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace scenefile::testing {
namespace {

const std::string fixtures = SCENEFILE_FIXTURES "/format/";

ReadOptions options_for(const Code& code) {
  ReadOptions options;
  options.compat_course = code.name == "xml.after-object-used";
  if (code.name.ends_with("-limit")) {
    options.limits.nesting = 8;
    options.limits.attributes = 8;
    options.limits.name_bytes = 32;
    options.limits.value_bytes = 64;
    options.limits.lights = 3;
  }
  return options;
}

bool gives(const std::string& path, const Code& code) {
  const Reading reading = read(file_text(path), options_for(code));
  const auto& list = reading.diagnostics.list();
  return std::any_of(list.begin(), list.end(),
                     [&](const Diagnostic& d) { return d.code == &code; });
}

std::string fixture_of(const Code& code, const std::string& ending) {
  return fixtures + std::string(code.name) + ending;
}

// Codes of JSON and of the writers have separate tests.
std::vector<const Code*> xml_codes() {
  std::vector<const Code*> codes = codes_of("format.");
  const std::vector<const Code*> of_xml = codes_of("xml.");
  codes.insert(codes.end(), of_xml.begin(), of_xml.end());
  return codes;
}

class FormatCode : public ::testing::TestWithParam<const Code*> {};

TEST_P(FormatCode, IsTriggeredByItsFixture) {
  const std::string path = fixture_of(*GetParam(), ".xml");
  ASSERT_TRUE(std::filesystem::exists(path)) << path;
  EXPECT_TRUE(gives(path, *GetParam()));
}

TEST_P(FormatCode, IsNotTriggeredByASimilarFile) {
  const std::string path = fixture_of(*GetParam(), ".ok.xml");
  ASSERT_TRUE(std::filesystem::exists(path)) << path;
  EXPECT_FALSE(gives(path, *GetParam()));
}

INSTANTIATE_TEST_SUITE_P(All, FormatCode, ::testing::ValuesIn(xml_codes()), [](const auto& code) {
  std::string name(code.param->name);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '.' || c == '-'; }, '_');
  return name;
});

// Near misses are valid scenes, except for findings that they cannot avoid.
TEST(FormatCodes, NearMissesHaveNoErrors) {
  for (const Code* code : xml_codes()) {
    const Reading reading = read(file_text(fixture_of(*code, ".ok.xml")), options_for(*code));
    EXPECT_FALSE(reading.diagnostics.has_errors()) << code->name;
  }
}

}  // namespace
}  // namespace scenefile::testing
