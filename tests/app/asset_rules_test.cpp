// The rules for finding textures and meshes, as reported by `info --files`; nothing outside the
// roots is opened.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

// A scene in the folder "fun" that uses a mesh of that name.
struct AssetRules : ProgramFolder {
  void SetUp() override { folder.write("fun/sub/a.obj", triangle); }

  std::string scene(const std::string& file) const {
    std::string text = good_scene;
    text.replace(text.find("name=\"sphere\""), 13, "name=\"mesh\" filename=\"" + file + "\"");
    return folder.write("fun/s.xml", text);
  }

  std::string told(const std::string& file, std::vector<std::string> options = {},
                   const RunSettings& settings = {}) const {
    options.insert(options.begin(), {"info", "--files"});
    options.push_back(scene(file));
    const ProgramRun run = run_program(options, settings);
    EXPECT_EQ(run.status, 0) << run.err;
    return run.out.substr(std::min(run.out.find("mesh \""), run.out.size()));
  }

  std::string found(const std::string& rule, const std::string& path) const {
    return rule + ": " + folder.path(path) + "\n";
  }
};

TEST_F(AssetRules, AbsoluteInsideARoot) {
  EXPECT_THAT(told(folder.path("fun/sub/a.obj")), HasSubstr(found("as written", "fun/sub/a.obj")));
}

TEST_F(AssetRules, NextToTheScene) {
  EXPECT_THAT(told("sub/a.obj"), HasSubstr(found("next to the scene", "fun/sub/a.obj")));
  EXPECT_THAT(told("sub\\a.obj"), HasSubstr(found("next to the scene", "fun/sub/a.obj")));
}

TEST_F(AssetRules, InTheParentFolder) {
  folder.write("mesh/b.obj", triangle);
  folder.write("other/c.obj", triangle);
  EXPECT_THAT(told("mesh/b.obj"), HasSubstr(found("next to the scene's folder", "mesh/b.obj")));
  EXPECT_THAT(told("other/c.obj"), HasSubstr("no such file"));
}

TEST_F(AssetRules, UnderTheAssetRootsInTheirOrder) {
  folder.write("one/e.obj", triangle);
  folder.write("two/e.obj", triangle);
  folder.write("two/f.obj", triangle);
  const std::vector<std::string> roots{"--asset-root", folder.path("one"), "--asset-root",
                                       folder.path("two")};
  EXPECT_THAT(told("e.obj", roots), HasSubstr(found("in an asset root", "one/e.obj")));
  EXPECT_THAT(told("f.obj", roots), HasSubstr(found("in an asset root", "two/f.obj")));
  EXPECT_THAT(told("f.obj"), HasSubstr("no such file"));
}

TEST_F(AssetRules, TheCoursesFolder) {
  folder.write("data/image/g.obj", triangle);
  EXPECT_THAT(told("/course/cs123/data/image/g.obj", {},
                   {.environment = {"CS123_DATA=" + folder.path("data")}}),
              HasSubstr(found("by the end of its path", "data/image/g.obj")));
}

TEST_F(AssetRules, TheTailOfThePathThenIgnoringCase) {
  EXPECT_THAT(told("/home/someone/sub/a.obj"),
              HasSubstr(found("by the end of its path", "fun/sub/a.obj")));
  EXPECT_THAT(told("C:\\Projects\\sub\\a.obj"),
              HasSubstr(found("by the end of its path", "fun/sub/a.obj")));
  EXPECT_THAT(told("Sub/A.OBJ"), HasSubstr(found("by the end of its path", "fun/sub/a.obj")));
}

TEST_F(AssetRules, OnlyTheNameIfUnique) {
  EXPECT_THAT(told("elsewhere/a.obj"), HasSubstr(found("by its name alone", "fun/sub/a.obj")));
  folder.write("fun/other/a.obj", triangle);
  EXPECT_THAT(told("elsewhere/a.obj"), HasSubstr("2 files have its name"));
}

TEST_F(AssetRules, OutsideOnlyIfAllowed) {
  const std::string secret = folder.write("secret/h.obj", triangle);
  ASSERT_EQ(::symlink("../secret/h.obj", folder.path("fun/link.obj").c_str()), 0);
  for (const std::string& name :
       {secret, std::string("../secret/h.obj"), std::string("link.obj")}) {
    EXPECT_THAT(told(name), AllOf(HasSubstr(name == "link.obj" ? "link.obj is a link that leads out"
                                                               : "no such file"),
                                  Not(HasSubstr("permission"))))
        << name;
    EXPECT_THAT(told(name, {"--allow-outside"}), HasSubstr(": " + secret + "\n")) << name;
    const std::string file = scene(name);
    EXPECT_EQ(run_program({"check", file}).status, 1) << name;
    EXPECT_EQ(run_program({"check", "--allow-outside", file}).status, 0) << name;
    EXPECT_EQ(run_program({"check", "--asset-root", folder.path("secret"), file}).status, 0)
        << name;
  }
}

TEST_F(AssetRules, JsonNamesTheRule) {
  const rapidjson::Document report =
      parse_json(run_program({"info", "--files", "--json", scene("sub/a.obj")}).out);
  EXPECT_STREQ(report["files"][0]["rule"].GetString(), "next to the scene");
}

}  // namespace

}  // namespace scenefile
