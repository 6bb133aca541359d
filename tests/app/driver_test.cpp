// The course's driver: it writes a configuration for each scene and calls projects_ray with it as
// the only argument.

#include "app/run_program.h"
#include "scenefile/asset/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace scenefile {
namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

const std::string projects_ray = fs::path(SCENEFILE_PROGRAM).parent_path() / "projects_ray";

constexpr std::array<const char*, 7> words{
    "shadows", "reflect", "refract", "texture", "texture-filter", "super-sample", "depthoffield"};

std::string config_text(const std::string& scene, const std::string& output,
                        const std::string& features) {
  std::string text = "[IO]\n\tscene = " + scene + "\n\toutput = " + output +
                     "\n\n[Canvas]\n\twidth = 40\n\theight = 30\n\n[Feature]\n";
  for (const std::string word : words) {
    const bool on = ("," + features + ",").find("," + word + ",") != std::string::npos;
    text += "\t" + word + " = " + (on ? "true\n" : "false\n");
  }
  return text + "\tparallel = true\n\tacceleration = true\n";
}

struct Driver : ::testing::Test {
  ProgramRun drive(const std::string& config, const std::string& working_folder = "/") const {
    return run_program({config}, {.folder = working_folder, .program = projects_ray});
  }

  // The picture of the driver is that of the command line.
  void compare(const std::string& scene, const std::string& features) const {
    const std::string driven = folder.path("driven.png");
    const std::string asked = folder.path("asked.png");
    fs::remove(driven);
    const ProgramRun run = drive(folder.write("c.ini", config_text(scene, driven, features)));
    const ProgramRun other =
        run_program({"render", scene, "-o", asked, "--size", "40x30", "--profile", "course",
                     "--features", features.empty() ? "none" : features});
    EXPECT_EQ(run.status, other.status) << scene << "\n" << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(fs::exists(driven), run.status == 0);
    if (run.status == 0) {
      EXPECT_TRUE(folder.read("driven.png") == folder.read("asked.png")) << scene;
    }
  }

  TempFolder folder;
};

std::vector<std::string> scenes_in(const fs::path& root) {
  std::vector<std::string> scenes;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (entry.path().extension() == ".xml" || entry.path().extension() == ".json") {
      scenes.push_back(entry.path());
    }
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

TEST_F(Driver, PicturesAreThoseOfRender) {
  const std::vector<std::string> scenes = scenes_in(SCENEFILE_SCENES);
  ASSERT_FALSE(scenes.empty());
  for (const std::string& scene : scenes) {
    for (const char* const features :
         {"", "shadows,reflect,texture,super-sample",
          "shadows,reflect,refract,texture,texture-filter,super-sample",
          "shadows,reflect,refract,texture,texture-filter,depthoffield"}) {
      compare(scene, features);
    }
  }
}

TEST_F(Driver, PicturesOfTheCorpusAreThoseOfRender) {
  const char* const corpus = std::getenv("SCENEFILE_CORPUS");
  if (corpus == nullptr || *corpus == '\0') {
    GTEST_SKIP() << "SCENEFILE_CORPUS names no folder";
  }
  for (const std::string& scene : scenes_in(fs::absolute(corpus))) {
    compare(scene, "shadows,reflect,refract,texture,texture-filter");
  }
}

TEST_F(Driver, EachFeatureReachesThePicture) {
  const std::string scene = folder.write("scene.xml", scene_with(R"(<reflective r="1" g="1" b="1"/>
      <transparent r="1" g="1" b="1"/>)"));
  for (const char* const word : words) {
    compare(scene, word);
  }
}

TEST_F(Driver, RelativePathsStartAtTheWorkingFolder) {
  folder.write("scene.xml", good_scene);
  const std::string config = folder.write("c.ini", config_text("scene.xml", "out.png", ""));
  EXPECT_EQ(drive(config, folder.path(".")).status, 0);
  EXPECT_FALSE(folder.read("out.png").empty());
  const ProgramRun elsewhere = drive(config, "/");
  EXPECT_EQ(elsewhere.status, 3);
  EXPECT_THAT(elsewhere.err, HasSubstr("start at the working directory"));
}

TEST_F(Driver, DepthAndNormalsAreSettings) {
  const std::string scene = folder.write("scene.xml", good_scene);
  const std::string plain = config_text(scene, folder.path("out.png"), "");
  ASSERT_EQ(drive(folder.write("c.ini", plain)).status, 0);
  const std::string color = folder.read("out.png");
  const std::string text = plain + "[Settings]\nonly-render-normals = true\n";
  ASSERT_EQ(drive(folder.write("c.ini", text)).status, 0);
  EXPECT_NE(folder.read("out.png"), color);
}

TEST_F(Driver, MistakesHaveAPlace) {
  const std::string config = folder.write("c.ini", "[IO]\nscene = a.xml\nouput = a.png\n");
  const ProgramRun run = drive(config);
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, AllOf(HasSubstr("c.ini:3:1: warning: unknown key [IO] ouput"),
                             HasSubstr("did you mean [IO] output?"),
                             HasSubstr("error: the configuration lacks [IO] output"),
                             HasSubstr("lacks [Canvas] height")));
}

TEST_F(Driver, UnknownKeysAreNoObstacle) {
  const std::string scene = folder.write("scene.xml", good_scene);
  const std::string text =
      config_text(scene, folder.path("out.png"), "") + "post-process = false\nnum-samples = 1\n";
  const ProgramRun run = drive(folder.write("c.ini", text));
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.err, HasSubstr("config.unknown-key"));
}

TEST_F(Driver, OtherEndingsBecomePng) {
  const std::string scene = folder.write("scene.xml", good_scene);
  const ProgramRun run =
      drive(folder.write("c.ini", config_text(scene, folder.path("out.jpg"), "")));
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.err, HasSubstr("config.picture-format"));
  EXPECT_EQ(folder.read("out.jpg").substr(1, 3), "PNG");
}

TEST_F(Driver, ASceneInPlaceOfAConfigurationIsCalledOne) {
  const std::string large = std::string(good_scene) + std::string(100'000, ' ');
  for (const std::string& scene :
       {folder.write("scene.xml", good_scene), folder.write("large.xml", large),
        folder.write("scene.json", R"({"groups": []})"), folder.write("scene", good_scene)}) {
    const ProgramRun run = drive(scene);
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.err,
                HasSubstr(scene + " is a scene; projects_ray takes a configuration that names"));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 2) << run.err;
  }
  EXPECT_EQ(drive("/nowhere/scene.xml").status, 3);
}

TEST_F(Driver, ExplainsItselfAndItsUse) {
  const ProgramRun help = run_program({"--help"}, {.program = projects_ray});
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.out, HasSubstr("[Canvas]"));
  EXPECT_EQ(run_program({}, {.program = projects_ray}).status, 2);
  EXPECT_EQ(run_program({"a", "b"}, {.program = projects_ray}).status, 2);
  EXPECT_EQ(drive("/nowhere/c.ini").status, 3);
}

}  // namespace
}  // namespace scenefile
