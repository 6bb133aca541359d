// For every code of the JSON reader: a file that causes it, and a similar one that does not.

#include "format/codes_of.h"
#include "scenefile/format/read_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

namespace scenefile {
namespace {

std::string fixture(const Code& code, const char* ending) {
  const std::string path =
      std::string(SCENEFILE_FIXTURES "/format_json/") + std::string(code.name) + ending;
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << "missing " << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

bool gives(const Diagnostics& diagnostics, const Code& code) {
  return std::any_of(diagnostics.list().begin(), diagnostics.list().end(),
                     [&](const Diagnostic& d) { return d.code == &code; });
}

TEST(JsonCodes, EachIsTriggeredByItsFixture) {
  for (const Code* code : codes_of("json.")) {
    const std::string text = fixture(*code, ".json");
    Diagnostics diagnostics;
    read_scene(text, {}, diagnostics);
    EXPECT_TRUE(gives(diagnostics, *code)) << code->name;
    EXPECT_EQ(diagnostics.list().size(), 1u) << code->name;
    for (const Diagnostic& d : diagnostics.list()) {
      EXPECT_TRUE(d.location.known()) << code->name;
      EXPECT_EQ(d.severity, code->severity) << code->name;
      EXPECT_EQ(d.message.find('\n'), std::string::npos) << code->name;
    }
  }
}

TEST(JsonCodes, NoneIsTriggeredByASimilarFile) {
  for (const Code* code : codes_of("json.")) {
    Diagnostics diagnostics;
    read_scene(fixture(*code, ".ok.json"), {}, diagnostics);
    EXPECT_TRUE(diagnostics.list().empty())
        << code->name << ": " << diagnostics.list().front().message;
  }
}

}  // namespace
}  // namespace scenefile
