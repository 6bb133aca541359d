// Configurations of the course, as the only argument of projects_ray and projects_path, as the
// course's drivers call them, and as an argument of render.

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

struct Driver : ProgramFolder {
  ProgramRun drive(const std::string& config, const std::string& working_folder = "/") const {
    return run_program({config}, {.folder = working_folder, .program = projects_ray});
  }

  // The driver's picture equals the command line's picture.
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

// A textured glass sphere that also reflects, in front of a wall with its shadow, seen through a
// lens: each feature changes some pixel.
const char* const scene_of_all_features = R"(<scenefile>
  <globaldata>
    <ambientcoeff v="0.5"/> <diffusecoeff v="0.5"/> <specularcoeff v="0.5"/>
    <transparentcoeff v="0.5"/>
  </globaldata>
  <cameradata>
    <pos x="0" y="0" z="3"/> <look x="0" y="0" z="-1"/> <up x="0" y="1" z="0"/>
    <heightangle v="40"/> <aperture v="0.2"/> <focallength v="3"/>
  </cameradata>
  <lightdata>
    <id v="0"/> <type v="directional"/> <color r="1" g="1" b="1"/> <direction x="-1" y="-1" z="-1"/>
  </lightdata>
  <object type="tree" name="root">
    <transblock>
      <object type="primitive" name="sphere">
        <diffuse r="1" g="0.5" b="0"/> <ambient r="0.1" g="0.1" b="0.1"/>
        <reflective r="0.4" g="0.4" b="0.4"/> <transparent r="0.4" g="0.4" b="0.4"/> <ior v="1.4"/>
        <texture file="checks.png" u="1.7" v="1.3"/> <blend v="0.6"/>
      </object>
    </transblock>
    <transblock>
      <translate x="0" y="0" z="-1.5"/> <scale x="6" y="6" z="0.2"/>
      <object type="primitive" name="cube">
        <diffuse r="0.2" g="0.7" b="0.9"/> <reflective r="0.2" g="0.2" b="0.2"/>
      </object>
    </transblock>
  </object>
</scenefile>
)";

std::string checks_png() {
  Image image(5, 5);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    image.rgb[i] = static_cast<float>(i / 3 % 2);
  }
  return *encode_image(image, ImageFormat::png8, Rounding::nearest);
}

TEST_F(Driver, EachFeatureReachesThePicture) {
  const std::string scene = folder.write("scene.xml", scene_of_all_features);
  folder.write("checks.png", checks_png());
  const auto driven = [&](const std::string& features) {
    compare(scene, features);
    return folder.read("driven.png");
  };
  for (const std::string word : words) {
    const std::string without = word == "texture-filter" ? "texture" : "";
    const std::string with = without.empty() ? word : without + "," + word;
    EXPECT_NE(driven(without), driven(with)) << word;
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
  const std::string scene = folder.write("scene.xml", scene_of_all_features);
  folder.write("checks.png", checks_png());
  const auto driven = [&](const std::string& settings) {
    const std::string text = config_text(scene, folder.path("out.png"), "reflect,refract");
    const ProgramRun run =
        drive(folder.write("c.ini", text + (settings.empty() ? "" : "[Settings]\n" + settings)));
    EXPECT_EQ(run.status, 0) << run.err;
    return folder.read("out.png");
  };
  const auto asked = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{
        "render",    scene,    "-o",         folder.path("asked.png"), "--size", "40x30",
        "--profile", "course", "--features", "reflect,refract"};
    words.insert(words.end(), options.begin(), options.end());
    EXPECT_EQ(run_program(words).status, 0);
    return folder.read("asked.png");
  };
  const std::string plain = driven("");
  EXPECT_EQ(plain, asked({}));
  const std::string normals = driven("only-render-normals = true\n");
  EXPECT_NE(normals, plain);
  EXPECT_EQ(normals, asked({"--mode", "normals"}));
  const std::string shallow = driven("maximum-recursive-depth = 0\n");
  EXPECT_NE(shallow, plain);
  EXPECT_EQ(shallow, asked({"--max-depth", "0"}));
}

TEST_F(Driver, ErrorsHaveAPlace) {
  const std::string config = folder.write("c.ini", "[IO]\nscene = a.xml\nouput = a.png\n");
  const ProgramRun run = drive(config);
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, AllOf(HasSubstr("c.ini:3:1: warning: unknown key [IO] ouput"),
                             HasSubstr("did you mean [IO] output?"),
                             HasSubstr("error: the configuration is missing [IO] output"),
                             HasSubstr("is missing [Canvas] height")));
}

TEST_F(Driver, AConfigurationOfThePathTracerIsRefused) {
  const ProgramRun run = drive(
      folder.write("c.ini",
                   "[IO]\nscene=a.xml\noutput=a.png\n[Settings]\nimageWidth=4\nimageHeight=4\n"
                   "samplesPerPixel=1\npathContinuationProb=0.5\ndirectLightingOnly=false\n"
                   "numDirectLightingSamples=1\n"));
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("c.ini is a configuration of the path tracer"));
  EXPECT_THAT(run.err, HasSubstr("use projects_path, or scenefile render"));
}

TEST_F(Driver, RenderTakesTheConfiguration) {
  const std::string scene = folder.write("scene.xml", scene_of_all_features);
  folder.write("checks.png", checks_png());
  const std::string config =
      folder.write("c.ini", config_text(scene, folder.path("out.png"), "reflect,texture"));
  ASSERT_EQ(drive(config).status, 0);
  const std::string driven = folder.read("out.png");
  fs::remove(folder.path("out.png"));
  EXPECT_EQ(run_program({"render", config}).status, 0);
  EXPECT_EQ(folder.read("out.png"), driven);
  const ProgramRun run = run_program({"explain", config, "--pixel", "20,15", "--json"});
  EXPECT_STREQ(parse_json(run.out)["profile"].GetString(), "course") << run.err;
}

TEST_F(Driver, UnknownKeysAreWarnings) {
  const std::string scene = folder.write("scene.xml", good_scene);
  const std::string text =
      config_text(scene, folder.path("out.png"), "") + "post-process = false\nnum-samples = 1\n";
  const ProgramRun run = drive(folder.write("c.ini", text));
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.err, HasSubstr("config.unknown-key"));
}

TEST_F(Driver, OtherExtensionsBecomePng) {
  const std::string scene = folder.write("scene.xml", good_scene);
  const ProgramRun run =
      drive(folder.write("c.ini", config_text(scene, folder.path("out.jpg"), "")));
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.err, HasSubstr("config.picture-format"));
  EXPECT_EQ(folder.read("out.jpg").substr(1, 3), "PNG");
}

TEST_F(Driver, ASceneInsteadOfAConfigurationIsReported) {
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

// A lamp over a floor, without lights.
struct PathDriver : ProgramFolder {
  PathDriver() {
    folder.write("box.mtl",
                 "newmtl white\nKd .7 .7 .7\nKs .1 .1 .1\nNs 9\nnewmtl lamp\nKe 3 3 3\n");
    folder.write("box.obj",
                 "mtllib box.mtl\nv -2 0 2\nv 2 0 2\nv 2 0 -2\nv -2 0 -2\n"
                 "v -1 3 -1\nv 1 3 -1\nv 1 3 1\nv -1 3 1\n"
                 "usemtl white\nf 1 2 3 4\nusemtl lamp\nf 5 6 7 8\n");
    folder.write("lamp.xml", R"(<scenefile><cameradata><pos x="0" y="2" z="6"/>
      <focus x="0" y="0" z="0"/><up x="0" y="1" z="0"/><heightangle v="45"/></cameradata>
      <object type="tree" name="root"><transblock>
      <object type="primitive" name="mesh" filename="box.obj"/></transblock></object></scenefile>)");
  }

  static std::string config(const std::string& more, const std::string& output = "out.png") {
    return "[IO]\n    scene = lamp.xml\n    output = " + output +
           "\n\n[Settings]\n    imageWidth = 32\n    imageHeight = 24\n" + more;
  }
  ProgramRun run(const Words& words, const std::string& program = "") const {
    return run_program(words, {.folder = folder.path("."), .program = program});
  }
  // The picture of a configuration is that of render with these options.
  void compare(const std::string& text, const Words& options) const {
    folder.write("c.ini", config(text));
    const ProgramRun driven = run({"c.ini"}, projects_path);
    EXPECT_EQ(driven.status, 0) << driven.err;
    const ProgramRun asked =
        run(Words{"render", "lamp.xml", "-o", "asked.png", "--size", "32x24", "--mode", "path"} +
            options);
    EXPECT_EQ(asked.status, 0) << asked.err;
    EXPECT_FALSE(folder.read("asked.png").empty());
    EXPECT_TRUE(folder.read("out.png") == folder.read("asked.png")) << text;
  }

  const std::string projects_path = fs::path(SCENEFILE_PROGRAM).parent_path() / "projects_path";
};

TEST_F(PathDriver, KeysAreOptions) {
  compare("samplesPerPixel=3\npathContinuationProb=0.6\nnumDirectLightingSamples=2\n",
          {"--samples", "3", "--continue", "0.6", "--light-samples", "2"});
  compare("samplesPerPixel=4\npathContinuationProb=0.9\ndirectLightingOnly=true\n",
          {"--samples", "4", "--continue", "0.9", "--direct-only"});
  compare("samplesPerPixel=2\npathContinuationProb=1\n", {"--samples", "2", "--continue", "0.99"});
  compare("samplesPerPixel=2\npathContinuationProb=1e-9\n",
          {"--samples", "2", "--continue", "0.01"});
  compare("samplesPerPixel=2\npathContinuationProb=0\n", {"--samples", "2", "--max-depth", "1"});
  compare("", {"--samples", "1", "--max-depth", "1"});  // all defaults
  compare("samplesPerPixel=0\nnumDirectLightingSamples=0\nraysPerBounce=7\n",
          {"--samples", "1", "--max-depth", "1"});
}

TEST_F(PathDriver, WarnsOfKeysUnlessQuiet) {
  folder.write("c.ini", config("samplesPerPixel=1\nraysPerBounce=7\n"));
  const ProgramRun loud = run({"render", "c.ini"});
  EXPECT_EQ(loud.status, 0);
  EXPECT_THAT(loud.err,
              AllOf(HasSubstr("unknown key [Settings] raysPerBounce"),
                    HasSubstr("missing [Settings] pathContinuationProb; it counts as 0")));
  const ProgramRun quiet = run({"render", "c.ini", "-q"});
  EXPECT_EQ(quiet.status, 0);
  EXPECT_EQ(quiet.err, "");
}

TEST_F(PathDriver, GivenOptionsCountMore) {
  folder.write("c.ini", config("samplesPerPixel=3\npathContinuationProb=0.6\n", "a/b/out.png"));
  ASSERT_EQ(run({"render", "c.ini", "--samples", "5", "-o", "other.pfm", "--size", "16x8"}).status,
            0);
  EXPECT_FALSE(fs::exists(folder.path("a")));
  ASSERT_EQ(run({"render", "lamp.xml", "-o", "asked.pfm", "--mode", "path", "--size", "16x8",
                 "--samples", "5", "--continue", "0.6"})
                .status,
            0);
  EXPECT_EQ(folder.read("other.pfm"), folder.read("asked.pfm"));
  EXPECT_EQ(parse_json(run({"render", "c.ini", "--json"}).out)["samples"].GetInt(), 3);
}

// Its picture is none of them.
TEST_F(PathDriver, FramesDoNotNeedAnOutput) {
  const Words frames{"frames", "c.ini", "--turntable", "2", "--samples", "1"};
  folder.write("c.ini", config("", "out.png"));
  const ProgramRun scenes = run(frames + Words{"--write-scenes", "s%d.xml"});
  EXPECT_EQ(scenes.status, 0) << scenes.err;
  EXPECT_THAT(scenes.err, HasSubstr("2 scenes written"));
  const ProgramRun none = run(frames);
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.err, HasSubstr("frames needs an output: -o frame%04d.png"));
  folder.write("c.ini", config("", "f%d.png"));
  EXPECT_EQ(run(frames).status, 0);
  EXPECT_TRUE(fs::exists(folder.path("f2.png")));
}

TEST_F(PathDriver, GivenOptionsThatContradictAreToldWhatTheConfigurationIs) {
  folder.write("c.ini", config("samplesPerPixel=3\npathContinuationProb=0\n"));
  const ProgramRun rays = run({"render", "c.ini", "--mode", "ray"});
  EXPECT_EQ(rays.status, 2);
  EXPECT_THAT(rays.err, HasSubstr("The configuration stands for: scenefile render lamp.xml -o "
                                  "out.png --mode=path --samples=3 --light-samples=1"));
  const ProgramRun longer = run({"render", "c.ini", "--continue", "0.5", "--json"});
  EXPECT_EQ(parse_json(longer.out)["max_depth"].GetInt(), 0);
}

TEST_F(PathDriver, APictureOfAnotherSizeIsNotExplained) {
  folder.write("c.ini", config("samplesPerPixel=1\n"));
  ASSERT_EQ(run({"render", "c.ini", "--size", "16x16"}).status, 0);
  const ProgramRun other = run({"explain", "c.ini", "--pixel", "3,3", "--mine", "out.png"});
  EXPECT_EQ(other.status, 2);
  EXPECT_THAT(other.err, HasSubstr("out.png\" is 16x16, but the size asked for is 32x24; --size "
                                   "16x16 asks for its own"));
}

TEST_F(PathDriver, AsksForItsOwnSize) {
  folder.write("c.ini", "[IO]\nscene = lamp.xml\noutput = out.png\n");
  const ProgramRun ran = run({"c.ini"}, projects_path);
  EXPECT_EQ(ran.status, 1);
  EXPECT_THAT(ran.err, HasSubstr("missing [Settings] imageWidth"));
}

TEST_F(PathDriver, CreatesTheFolderOfTheOutput) {
  folder.write("c.ini", config("samplesPerPixel=1\n", "student_outputs/final/a.png"));
  const ProgramRun ran = run({"c.ini"}, projects_path);
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_TRUE(fs::exists(folder.path("student_outputs/final/a.png")));
  folder.write("c.ini", config("samplesPerPixel=1\n", "lamp.xml/a.png"));
  EXPECT_EQ(run({"c.ini"}, projects_path).status, 3);
  fs::remove(folder.path("lamp.xml"));
  folder.write("c.ini", config("samplesPerPixel=1\n", "new/a.png"));
  const ProgramRun without = run({"c.ini"}, projects_path);
  EXPECT_EQ(without.status, 3);
  EXPECT_THAT(without.err, HasSubstr("start at the working directory"));
  EXPECT_FALSE(fs::exists(folder.path("new")));
}

TEST_F(PathDriver, ReplacesNoInput) {
  for (const std::string output : {"lamp.xml", "box.obj", "box.mtl", "c.ini"}) {
    folder.write("c.ini", config("samplesPerPixel=1\n", output));
    const std::string before = folder.read(output);
    for (const ProgramRun& refused : {run({"c.ini"}, projects_path), run({"render", "c.ini"})}) {
      EXPECT_EQ(refused.status, 2) << output << refused.err;
    }
    EXPECT_EQ(folder.read(output), before);
  }
}

TEST_F(PathDriver, RefusesWhatIsNoConfigurationOfPaths) {
  const std::string text = config_text("lamp.xml", "out.png", "");
  folder.write("c.ini", text);
  const ProgramRun other = run({"c.ini"}, projects_path);
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.err, HasSubstr("is a configuration of the ray tracer, not of the path tracer"));
  const ProgramRun scene = run({"lamp.xml"}, projects_path);
  EXPECT_EQ(scene.status, 1);
  EXPECT_THAT(scene.err, HasSubstr("is a scene; projects_path takes a configuration"));
  folder.write("c.ini", config("samplesPerPixel=-3\n"));
  EXPECT_EQ(run({"render", "c.ini"}).status, 1);
  folder.write("c.ini", "hello");
  EXPECT_EQ(run({"render", "c.ini"}).status, 1);
  EXPECT_EQ(run({"render", "nowhere.ini"}).status, 3);
  EXPECT_FALSE(fs::exists(folder.path("out.png")));
  const ProgramRun help = run({"--help"}, projects_path);
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.out, HasSubstr("samplesPerPixel"));
}

TEST_F(PathDriver, ConventionOfTheCourseChangesThePicture) {
  folder.write("c.ini", config("samplesPerPixel=2\n"));
  ASSERT_EQ(run({"render", "c.ini", "-o", "a.pfm"}).status, 0);
  ASSERT_EQ(run({"render", "c.ini", "-o", "b.pfm", "--convention", "course"}).status, 0);
  EXPECT_NE(folder.read("a.pfm"), folder.read("b.pfm"));
}

}  // namespace
}  // namespace scenefile
