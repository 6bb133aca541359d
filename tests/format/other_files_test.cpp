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
      {"// gamma\n/* 1 */ #version 3.7;\ncamera { }", "writes but does not read"},
      {"[IO]\nscene = a.json\n",
       "a configuration of the course's ray or path tracer, not a scene"}};
  for (const auto& [text, what] : files) {
    const Reading reading = read(text);
    EXPECT_THAT(messages(reading.diagnostics), ElementsAre(HasSubstr(what)));
    EXPECT_EQ(reading.diagnostics.list()[0].code->name, "format.unknown");
  }
}

TEST(OtherFiles, NothingAndWhiteSpace) {
  EXPECT_THAT(messages(read("").diagnostics), ElementsAre("0:0 the file is empty"));
  EXPECT_THAT(messages(read(" \n\t\n").diagnostics),
              ElementsAre("0:0 the file contains only white space"));
}

// SECURITY.md: findings show nothing of files that are not scenes.
TEST(OtherFiles, AreNotShown) {
  const std::pair<std::string_view, std::string_view> files[] = {
      {"secret:x:0:0\n"sv, "format.unknown"},
      {"\"secret\": 1"sv, "format.unknown"},
      {"a <secret> in a letter, and scenefile: not a tag"sv, "format.unknown"},
      {"// secret"sv, "format.unknown"},
      {"\x7f\x45LF\x02 secret"sv, "format.unknown"},
      {"<secret a=\"secret\"><b></secret>"sv, "xml.root-element"},
      {"<!-- <secret> --><project secret=1/>"sv, "xml.root-element"},
      {"<!DOCTYPE secret [<!ENTITY secret \"a\">]><secret/>"sv, "xml.root-element"},
      {"<<<<<<< secret"sv, "xml.root-element"},
      {"{\"secret\": .5, }"sv, "json.missing-key"},
      {"{\"groups\": [], \"secret\": 1}"sv, "json.missing-key"},
      {"{\"kind\": \"cameraData\", \"secret\": 1"sv, "json.missing-key"},
      {"[secret"sv, "json.wrong-type"},
      {"<?xml version=\"1.0\" encoding=\"secret\"?><a>\xe4</a>"sv, "format.encoding"},
      {"\xff\xfes\0e\0c\0r\0e\0t\0!"sv, "format.encoding"},
      {""sv, "format.empty"},
      {" \n"sv, "format.empty"}};
  for (const auto& [text, code] : files) {
    const Reading reading = read(text);
    ASSERT_EQ(reading.diagnostics.list().size(), 1u) << text;
    const Diagnostic& d = reading.diagnostics.list()[0];
    EXPECT_EQ(d.code->name, code) << text;
    EXPECT_FALSE(d.location.known()) << text;
    EXPECT_EQ(d.message.find("secret"), std::string::npos) << d.message;
    EXPECT_TRUE(reading.scene.incomplete);
  }
}

// Broken scenes are explained at their places.
TEST(OtherFiles, BrokenScenesAreShown) {
  const std::pair<std::string_view, std::string_view> files[] = {
      {"<scenfile>\n</scenfile>", "1:1 error xml.root-element"},
      {"junk <scenefile/>", "1:1 error format.unknown"},
      {"<globaldata/>", "1:1 error xml.root-element"},
      {"<scene><transblock/></scene>", "1:1 error xml.root-element"},
      {"<scenefile", "1:1 error xml.syntax"},
      {"\"globalData\": {}}", "1:1 error format.unknown"}};
  for (const auto& [text, what] : files) {
    EXPECT_EQ(findings(read(text).diagnostics).at(0), what) << text;
  }
}

TEST(OtherFiles, ScenesAreAccepted) {
  for (const std::string_view text :
       {"<scenefile/>", "[]", "{\"v\": 1}", "// v 1 2 3\n{\"groups\": []}", "/* [IO] */ {}"}) {
    const Reading reading = read(text);
    for (const Diagnostic& d : reading.diagnostics.list()) {
      EXPECT_NE(d.code->name, "format.unknown") << text;
    }
  }
}

// The reader of the detected syntax reports the comment.
TEST(OtherFiles, CommentsInFrontAreReportedAsSuch) {
  for (const std::string_view text :
       {"// a\n{\"groups\": []}", "/* a\n*/ {\"groups\": []}", "  // a\r// b\r {\"groups\": []}"}) {
    const Reading reading = read(text);
    ASSERT_FALSE(reading.diagnostics.list().empty());
    EXPECT_EQ(reading.diagnostics.list()[0].code->name, "json.comment") << text;
  }
  EXPECT_THAT(findings(read("// a\n<scenefile/>").diagnostics),
              ElementsAre("1:1 error xml.syntax"));
  EXPECT_THAT(findings(read("// a").diagnostics), ElementsAre("0:0 error format.unknown"));
}

}  // namespace
}  // namespace scenefile::testing
