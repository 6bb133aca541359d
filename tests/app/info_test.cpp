#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::HasSubstr;
using ::testing::Not;

struct Info : ProgramFolder {};

TEST_F(Info, CountsAndMeasures) {
  const std::string scene = folder.write("s.xml", good_scene);
  const ProgramRun run = run_program({"info", scene});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
  for (const std::string line :
       {"camera      position 0 0 3, look 0 0 -1, up 0 1 0, height angle 40 degrees\n",
        "lights      1 (1 directional)\n", "objects     1 (1 sphere)\n", "drawn       1\n",
        "bounds      -0.5 -0.5 -0.5 to 0.5 0.5 0.5, size 1 1 1\n", "textures    0\n"}) {
    EXPECT_THAT(run.out, HasSubstr(line));
  }
}

TEST_F(Info, ListsFoundAndMissingFiles) {
  folder.write("image/there.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::string text = scene_with(R"(<blend v="1"/><texture file="image/no.png" u="1" v="1"/>)");
  text.replace(text.find("name=\"sphere\""), 13, "name=\"mesh\" filename=\"/course/there.obj\"");
  const std::string scene = folder.write("scenes/s.xml", text);
  const ProgramRun run = run_program({"info", "--files", scene});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("textures    1, 1 missing\n"));
  EXPECT_THAT(run.out, HasSubstr("texture \"image/no.png\" (line 15): no such file"));
  EXPECT_THAT(run.out, HasSubstr("    looked for image/no.png\n"));
  EXPECT_THAT(run.out, HasSubstr("mesh \"/course/there.obj\" (line 14): by its name alone: " +
                                 folder.path("image/there.obj")));
}

TEST_F(Info, ShowsTheTree) {
  const std::string scene = folder.write("s.xml", good_scene);
  EXPECT_THAT(run_program({"info", "--tree", scene}).out, HasSubstr("root: "));
  EXPECT_THAT(run_program({"info", "--tree", scene}).out, HasSubstr("1 sphere"));
}

TEST_F(Info, JsonIsOneDocument) {
  const std::string scene = folder.write("s.xml", good_scene);
  const ProgramRun run = run_program({"info", "--json", scene});
  EXPECT_EQ(run.status, 0);
  const rapidjson::Document report = parse_json(run.out);
  EXPECT_EQ(report["summary"]["primitives"]["sphere"].GetInt(), 1);
  EXPECT_EQ(report["bounds"]["min"][0].GetDouble(), -0.5);
  EXPECT_FALSE(report.HasMember("tree"));
}

TEST_F(Info, ABrokenSceneHasNoSummary) {
  const ProgramRun run = run_program({"info", "-"}, {.input = "<scenefile>"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, HasSubstr("<stdin>: 1 error"));
  const ProgramRun json = run_program({"info", "--json", "-"}, {.input = "<scenefile>"});
  EXPECT_EQ(json.status, 1);
  EXPECT_EQ(parse_json(json.out)["scene"]["errors"].GetInt(), 1);
}

}  // namespace

}  // namespace scenefile
