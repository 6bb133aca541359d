// check --fix and --dry-run.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace scenefile {
namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string right = scene_with(R"(<diffuse r="1" g="0.5" b="0"/>)");
const std::string wrong = scene_with(R"(<difuse r="1" g="0,5" b="0"/>)");

struct CheckFix : ProgramFolder {};

TEST_F(CheckFix, RewritesFilesAndSaysHow) {
  const std::string file = folder.write("a.xml", wrong);
  folder.write("b.xml", right);
  ASSERT_EQ(::chmod(file.c_str(), 0640), 0);
  const ProgramRun first = program({"check", "--fix", "a.xml", "b.xml"});
  EXPECT_EQ(first.status, 0) << first.out;
  EXPECT_THAT(first.out, HasSubstr("a.xml:15:9: fixed: unknown element <difuse> in <object>; did "
                                   "you mean <diffuse>? [xml.misspelled-element]\n"));
  EXPECT_THAT(first.out, AllOf(HasSubstr("a.xml: fine"), HasSubstr("2 scenes: 2 fine")));
  EXPECT_EQ(folder.read("a.xml"), right);
  EXPECT_EQ(folder.read("b.xml"), right);
  struct stat status {};
  ASSERT_EQ(::stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
  EXPECT_EQ(folder.list().size(), 2U);
  EXPECT_THAT(program({"check", "--fix", "a.xml"}).out, Not(HasSubstr("fixed")));
}

TEST_F(CheckFix, SaysWhyAFileInUtf16IsNotFixed) {
  const auto utf16 = [](std::string_view text) {
    std::string bytes = "\xFF\xFE";
    for (const char c : text) {
      bytes += {c, '\0'};
    }
    return bytes;
  };
  const std::string why = "a.xml: not fixed: the file is in UTF-16; save it as UTF-8 first\n";
  folder.write("a.xml", utf16(wrong));
  EXPECT_THAT(program({"check", "--fix", "a.xml"}).err, HasSubstr(why));
  EXPECT_THAT(program({"check", "--dry-run", "a.xml"}).err, HasSubstr(why));
  EXPECT_EQ(folder.read("a.xml"), utf16(wrong));
  folder.write("a.xml", utf16(right));
  EXPECT_THAT(program({"check", "--fix", "a.xml"}).err, Not(HasSubstr("not fixed")));
}

TEST_F(CheckFix, DryRunShowsAPatch) {
  folder.write("a.xml", wrong);
  const ProgramRun dry = program({"check", "--dry-run", "a.xml"});
  EXPECT_EQ(dry.status, 0);
  EXPECT_THAT(dry.out,
              AllOf(::testing::StartsWith("--- a.xml\n+++ a.xml\n@@ -12,7 +12,7 @@\n"),
                    HasSubstr("\n-"), HasSubstr("difuse r=\"1\" g=\"0,5\""),
                    HasSubstr("<diffuse r=\"1\" g=\"0.5\" b=\"0\"/>"), Not(HasSubstr("fine"))));
  EXPECT_THAT(dry.err, AllOf(HasSubstr("a.xml:15:9: fixed: "), HasSubstr("a.xml: fine")));
  EXPECT_EQ(folder.read("a.xml"), wrong);
}

TEST_F(CheckFix, StandardInputBecomesStandardOutput) {
  const ProgramRun fixed = program({"check", "--fix", "-"}, wrong);
  EXPECT_EQ(fixed.status, 0);
  EXPECT_EQ(fixed.out, right);
  EXPECT_THAT(fixed.err, HasSubstr("<stdin>:15:9: fixed: "));
  const ProgramRun same = program({"check", "--fix", "-"}, "<scenefile><object></scenefile>");
  EXPECT_EQ(same.status, 1);
  EXPECT_EQ(same.out, "<scenefile><object></scenefile>");
  EXPECT_EQ(program({"check", "--fix", "--json", "-"}, wrong).status, 2);
}

TEST_F(CheckFix, LinksAreFollowedAndAFileIsFixedOnce) {
  folder.write("a.xml", wrong);
  std::filesystem::create_symlink("a.xml", folder.path() + "/link.xml");
  const ProgramRun dry = program({"check", "--dry-run", "a.xml", "link.xml"});
  EXPECT_EQ(dry.out.find("+++", dry.out.find("+++") + 1), std::string::npos);
  EXPECT_EQ(program({"check", "--fix", "link.xml", "a.xml"}).status, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() + "/link.xml"));
  EXPECT_EQ(folder.read("a.xml"), right);
}

TEST_F(CheckFix, WhatCannotBeWrittenStaysAsItIs) {
  const ProgramRun failed =
      run_program({"check", "--fix", "-"}, {.input = wrong, .out_file = "/dev/full"});
  EXPECT_EQ(failed.status, 3);
  EXPECT_THAT(failed.err, AllOf(HasSubstr("error: unknown element <difuse>"), HasSubstr("2 errors"),
                                Not(HasSubstr("fixed"))));
  EXPECT_EQ(program({"check", "--fix", "none.xml"}).status, 3);
}

TEST_F(CheckFix, JsonSaysWhatWasFixedAndWhatIsLeft) {
  folder.write("a.xml", scene_with(R"(<difuse r="1" g="1" b="x"/>)"));
  const ProgramRun fixed = program({"check", "--fix", "--json", "a.xml"});
  EXPECT_EQ(fixed.status, 1);
  const rapidjson::Document document = parse_json(fixed.out);
  const auto& scene = document["scenes"][0];
  ASSERT_EQ(scene["fixed"].Size(), 1U);
  EXPECT_STREQ(scene["fixed"][0]["correction"]["instead"].GetString(), "diffuse");
  EXPECT_STREQ(scene["findings"][0]["code"].GetString(), "xml.number");
  folder.write("b.xml", wrong);
  const rapidjson::Document plain = parse_json(program({"check", "--json", "b.xml"}).out);
  const auto& change = plain["scenes"][0]["findings"][0]["correction"]["changes"][0];
  EXPECT_EQ(change["column"].GetInt(), 10);
  EXPECT_EQ(change["end_column"].GetInt(), 16);
  EXPECT_FALSE(plain["scenes"][0].HasMember("fixed"));
}

TEST_F(CheckFix, AllowedCodesAreLeftAlone) {
  folder.write("a.xml", scene_with(R"(<Diffuse r="1" g="1" b="1"/>)"));
  EXPECT_EQ(program({"check", "--dry-run", "--allow", "xml.name-case", "a.xml"}).out, "");
  EXPECT_NE(program({"check", "--dry-run", "a.xml"}).out, "");
}

TEST_F(CheckFix, SarifHasFixes) {
  folder.write("a.xml", wrong);
  const rapidjson::Document document = parse_json(program({"check", "--sarif", "a.xml"}).out);
  const auto& change = document["runs"][0]["results"][0]["fixes"][0]["artifactChanges"][0];
  EXPECT_STREQ(change["artifactLocation"]["uri"].GetString(), "a.xml");
  const auto& replacement = change["replacements"][0];
  EXPECT_EQ(replacement["deletedRegion"]["startColumn"].GetInt(), 10);
  EXPECT_STREQ(replacement["insertedContent"]["text"].GetString(), "diffuse");
}

}  // namespace
}  // namespace scenefile
