#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::HasSubstr;

struct DiffScenes : ProgramFolder {};

TEST_F(DiffScenes, EqualScenesHaveNoDifference) {
  const std::string a = folder.write("a.xml", good_scene);
  const ProgramRun run = run_program({"diff", a, "-"}, {.input = good_scene});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, a + " and <stdin>: no difference\n");
  EXPECT_EQ(run_program({"diff", "--quiet", a, a}).out, "");
  const ProgramRun piped = run_program({"diff", a, "/dev/stdin"}, {.input = good_scene});
  EXPECT_EQ(piped.status, 0) << piped.err;
}

TEST_F(DiffScenes, DifferencesHavePlacesInBothFiles) {
  folder.write("a.xml", scene_with(R"(<diffuse r="1" g="0.5" b="0"/>)"));
  std::string b = scene_with(R"(<diffuse r="1" g="0.25" b="0"/>)");
  b.insert(0, 1, '\n');
  folder.write("b.xml", b);
  const ProgramRun run = program({"diff", "a.xml", "b.xml"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.out, R"(--- a.xml
+++ b.xml
@@ a.xml:14:7 b.xml:15:7 @@ root/#1: sphere
   <object type="tree" name="root">
     <transblock>
       <object type="primitive" name="sphere">
-        <diffuse r="1" g="0.5" b="0"/>
+        <diffuse r="1" g="0.25" b="0"/>
       </object>
     </transblock>
   </object>
a.xml and b.xml: 1 difference
)");
  const auto has_colors = [&](const std::vector<std::string>& environment) {
    return run_program({"diff", "a.xml", "b.xml"},
                       {.environment = environment, .folder = folder.path(), .terminal = true})
               .out.find("\033[31m") != std::string::npos;
  };
  EXPECT_TRUE(has_colors({"TERM=xterm"}));
  EXPECT_FALSE(has_colors({"TERM=xterm", "NO_COLOR=1"}));
}

TEST_F(DiffScenes, UnreadableFilesAreErrorsNotDifferences) {
  const std::string a = folder.write("a.xml", good_scene);
  EXPECT_EQ(run_program({"diff", a, folder.path("none.xml")}).status, 3);
  const ProgramRun bad = run_program({"diff", folder.write("bad.xml", "<scenefile>"), a});
  EXPECT_EQ(bad.status, 1);
  EXPECT_EQ(bad.out, "");
  EXPECT_THAT(bad.err, HasSubstr("bad.xml:1:12: error: "));
  EXPECT_EQ(run_program({"diff", "-", "-"}).status, 2);
  EXPECT_EQ(run_program({"diff", a}).status, 2);
}

TEST_F(DiffScenes, DrawsNothing) {
  const std::string a = folder.write("a.xml", good_scene);
  const ProgramRun run = program({"diff", a, a, "--heatmap", "h.png"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("--heatmap is for pictures"));
  EXPECT_THAT(run_program({"diff", a, a, "--min-psnr", "40"}).err,
              HasSubstr("--min-psnr is for pictures"));
}

TEST_F(DiffScenes, PrintsTheReadersWarnings) {
  const std::string a = folder.write("a.xml", good_scene);
  const std::string b = folder.write("b.xml", scene_with(R"(<ior value="1"/>)"));
  EXPECT_THAT(run_program({"diff", a, b}).err, HasSubstr("[xml.alias-attribute]"));
  EXPECT_EQ(run_program({"diff", "-q", a, b}).err, "");
  EXPECT_THAT(run_program({"diff", a, a}).err, "");
}

TEST_F(DiffScenes, AnswersInJson) {
  const std::string a = folder.write("a.xml", good_scene);
  const std::string b = folder.write("b.xml", scene_with(R"(<ior v="2"/><blend v="0.5"/>)"));
  const rapidjson::Document document = parse_json(run_program({"diff", "--json", a, b}).out);
  EXPECT_FALSE(document["same_meaning"].GetBool());
  ASSERT_EQ(document["differences"].Size(), 1U);
  const auto& difference = document["differences"][0];
  EXPECT_STREQ(difference["where"].GetString(), "root/#1: sphere");
  EXPECT_STREQ(difference["a"]["text"].GetString(), "<diffuse r=\"1\" g=\"0.5\" b=\"0\"/>");
  EXPECT_STREQ(difference["b"]["text"].GetString(), "<ior v=\"2\"/>\n<blend v=\"0.5\"/>");
  EXPECT_EQ(difference["b"]["line"].GetInt(), 14);
}

}  // namespace

}  // namespace scenefile
