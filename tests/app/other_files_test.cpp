// SECURITY.md: of files that are not what they are given as, no command shows any content. Each is
// answered with one line.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

using namespace testing_support;
namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::string_view not_a_scene =
    ": error: not a scene file: a scene is XML with the element <scenefile>, or a JSON object "
    "[format.unknown]\n";

struct OtherFiles : ProgramFolder {
  /// What the commands that read scenes say about the file.
  std::vector<std::string> said_about(const std::string& path) const {
    const std::string good = folder.path("good.xml");
    std::vector<std::string> said;
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"check", "--quiet", path},
             {"check", path},
             {"info", path},
             {"render", path, "-o", folder.path("a.png")},
             {"frames", path, "--turntable", "2", "-o", folder.path("f%02d.png")},
             {"explain", path, "--pixel", "1,1"},
             {"convert", path, folder.path("a.json")},
             {"convert", path, folder.path("a.glb")},
             {"format", path},
             {"diff", path, good}}) {
      const ProgramRun run = run_program(words);
      EXPECT_NE(run.status, 0) << words[0];
      said.push_back(run.out + run.err);
    }
    return said;
  }
};

TEST_F(OtherFiles, AreAnsweredWithOneLine) {
  folder.write("good.xml", good_scene);
  folder.write("passwd", "secret:x:0:0\n");
  folder.write("empty.xml", "");
  folder.write("pom.xml", "<secret a=\"secret\"/>\n");
  folder.write("package.json", "{\"secret\": 1}\n");
  folder.write("binary.xml", std::string("\x7f"
                                         "ELF\0\x01secret\n",
                                         13));
  ASSERT_EQ(symlink("passwd", folder.path("link.xml").c_str()), 0);
  ASSERT_EQ(mkfifo(folder.path("pipe.xml").c_str(), 0600), 0);
  const std::pair<std::string, std::string> files[] = {
      {"passwd", std::string(not_a_scene)},
      {"link.xml", std::string(not_a_scene)},
      {"binary.xml", std::string(not_a_scene)},
      {"empty.xml", ": error: the file is empty [format.empty]\n"},
      {"pom.xml",
       ": error: the file is XML but not a scene: a scene is one element <scenefile> "
       "[xml.root-element]\n"},
      {"package.json",
       ": error: the file is JSON but not a scene: a scene is one object with the keys "
       "\"globalData\", \"cameraData\" and \"groups\" [json.missing-key]\n"},
      {"pipe.xml", ": is a pipe, not a regular file\n"}};
  for (const auto& [name, line] : files) {
    for (const std::string& said : said_about(folder.path(name))) {
      EXPECT_THAT(said, HasSubstr(folder.path(name) + line));
      EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
      EXPECT_THAT(said, Not(HasSubstr("secret")));
    }
  }
}

TEST_F(OtherFiles, ThatScenesOrOptionsNameAreNotShown) {
  const std::string secret =
      folder.write("secret.txt", "hidden one\nf hidden\nv hidden\no hidden\n");
  for (const char* const name : {"a.obj", "a.png", "a.ini", "a.mtl"}) {
    ASSERT_EQ(symlink("secret.txt", folder.path(name).c_str()), 0);
  }
  const std::string good = folder.write("good.xml", good_scene);
  const std::string scene =
      folder.write("scene.xml", scene_with(R"(<blend v="1"/><texture file="a.png" u="1" v="1"/>)"));
  std::string mesh_scene = good_scene;
  mesh_scene.replace(mesh_scene.find("name=\"sphere\""), 13, "name=\"mesh\" filename=\"a.obj\"");
  const std::string mesh = folder.write("mesh.xml", mesh_scene);
  const std::string json = folder.write("path.json", "{\"hidden\": 1}");
  const std::vector<std::vector<std::string>> commands = {
      {"check", scene},
      {"check", mesh},
      {"check", "--json", mesh},
      {"info", mesh},
      {"convert", folder.path("a.obj"), folder.path("b.xml")},
      {"frames", good, "--path", secret, "-o", folder.path("f%02d.png")},
      {"frames", good, "--path", json, "-o", folder.path("f%02d.png")},
      {"diff", secret, folder.path("a.png")}};
  for (const std::vector<std::string>& words : commands) {
    const ProgramRun run = run_program(words);
    EXPECT_THAT(run.out + run.err, Not(HasSubstr("hidden"))) << words[0];
  }
  const ProgramRun configured =
      run_program({folder.path("a.ini")},
                  {.program = fs::path(SCENEFILE_PROGRAM).parent_path() / "projects_ray"});
  EXPECT_EQ(configured.status, 1);
  EXPECT_EQ(configured.err, folder.path("a.ini") +
                                ": error: not a configuration: it has no key in a section [IO], "
                                "[Canvas], [Feature] or [Settings] [config.missing-key]\n");
}

}  // namespace

}  // namespace scenefile
