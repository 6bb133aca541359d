// Files that are not scenes are recognized.

#include "format/reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace scenefile::testing {
namespace {

using namespace std::string_view_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(OtherFiles, AreIdentified) {
  const std::pair<std::string_view, std::string_view> files[] = {
      {"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a", "git lfs pull"},
      {"\n\n<!DOCTYPE html>\n<html lang=\"en\">", "an HTML page"},
      {"<HTML><head/></HTML>", "an HTML page"},
      {"\x1f\x8b\x08\x00 packed"sv, "gzip; unpack it first"},
      {"PK\x03\x04 packed", "ZIP archive"},
      {"\x89PNG\r\n\x1a\n", "a picture"},
      {"# Blender\nmtllib a.mtl\nv 1 2 3\n", "an OBJ mesh"},
      {"v  -1 2 3\nv 1 2 3\n", "an OBJ mesh"},
      {"[IO]\nscene = a.json\n", "a configuration of the course's ray tracer"}};
  for (const auto& [text, what] : files) {
    const Reading reading = read(text);
    EXPECT_THAT(messages(reading.diagnostics), ElementsAre(HasSubstr(what)));
    EXPECT_EQ(reading.diagnostics.list()[0].code->name, "format.unknown");
  }
}

TEST(OtherFiles, ScenesAreAccepted) {
  for (const std::string_view text :
       {"<scenefile/>", "[]", "{\"v\": 1}", "// v 1 2 3\n{}", "/* [IO] */ {}"}) {
    const Reading reading = read(text);
    for (const Diagnostic& d : reading.diagnostics.list()) {
      EXPECT_NE(d.code->name, "format.unknown") << text;
    }
  }
}

// The reader of the detected syntax reports the comment.
TEST(OtherFiles, CommentsInFrontAreReportedAsSuch) {
  for (const std::string_view text : {"// a\n{}", "/* a\n*/ {}", "  // a\r// b\r {}"}) {
    const Reading reading = read(text);
    ASSERT_FALSE(reading.diagnostics.list().empty());
    EXPECT_EQ(reading.diagnostics.list()[0].code->name, "json.comment") << text;
  }
  EXPECT_THAT(findings(read("// a\n<scenefile/>").diagnostics),
              ElementsAre("1:1 error xml.syntax"));
  EXPECT_THAT(findings(read("// a").diagnostics), ElementsAre("1:1 error format.unknown"));
}

}  // namespace
}  // namespace scenefile::testing
