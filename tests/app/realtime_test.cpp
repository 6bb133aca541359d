// --profile realtime: options, output, and which lights are used.

#include "app/run_program.h"
#include "scenefile/asset/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::HasSubstr;
using ::testing::Not;

struct RealtimeProgram : ProgramFolder {
  static std::string fixture(const std::string& name) {
    return std::string(SCENEFILE_FIXTURES) + "/commands/" + name + ".json";
  }
  ProgramRun render(const std::string& scene, std::vector<std::string> more) const {
    std::vector<std::string> words{"render", scene,   "-o",        folder.path("p.png"),
                                   "--size", "64x48", "--profile", "realtime"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words);
  }
  std::string pixels() const {
    const Result<Texture> picture = decode_image(folder.read("p.png"));
    EXPECT_EQ(error_text(picture), "");
    return {picture->rgb.begin(), picture->rgb.end()};
  }
  static bool has_gl(const ProgramRun& run) { return run.status != 3; }
};

void is_refused(const std::vector<std::string>& words, const std::string& text) {
  const ProgramRun run = run_program(words);
  EXPECT_EQ(run.status, 2) << run.err;
  EXPECT_THAT(run.err, HasSubstr(text));
}

TEST_F(RealtimeProgram, AnswersInJson) {
  const ProgramRun run =
      render(fixture("realtime.light-skipped"),
             {"--json", "--parameters", "3,7", "--near", "0.5", "--far", "20", "--filter", "blur"});
  if (!has_gl(run)) {
    GTEST_SKIP() << run.err;
  }
  EXPECT_EQ(run.status, 0) << run.err;
  const rapidjson::Document json = parse_json(run.out);
  EXPECT_STREQ(json["profile"].GetString(), "realtime");
  EXPECT_STREQ(json["engine"].GetString(), "gl");
  EXPECT_STREQ(json["milestone"].GetString(), "lights-camera");
  EXPECT_STREQ(json["filter"].GetString(), "blur");
  EXPECT_EQ(json["parameters"][0].GetInt(), 3);
  EXPECT_EQ(json["parameters"][1].GetInt(), 7);
  EXPECT_EQ(json["near"].GetDouble(), 0.5);
  EXPECT_EQ(json["far"].GetDouble(), 20);
  EXPECT_EQ(json["triangles"].GetInt(), 7 * 4);
  EXPECT_EQ(json["lights_drawn"].GetInt(), 1);
  ASSERT_EQ(json["lights_skipped"].Size(), 1U);
  EXPECT_STREQ(json["lights_skipped"][0]["type"].GetString(), "point");
  EXPECT_GT(json["lights_skipped"][0]["line"].GetInt(), 1);
}

TEST_F(RealtimeProgram, TheMilestoneSelectsTheLights) {
  const std::string scene = fixture("realtime.light-skipped");
  if (const ProgramRun run = render(scene, {}); !has_gl(run)) {
    GTEST_SKIP() << run.err;
  }
  const std::string lights_camera = pixels();
  ASSERT_EQ(render(fixture("realtime.light-skipped.ok"), {}).status, 0);
  EXPECT_TRUE(pixels() == lights_camera) << "the point light is skipped";
  ASSERT_EQ(render(scene, {"--milestone", "action"}).status, 0);
  const std::string action = pixels();
  ASSERT_EQ(render(fixture("realtime.light-skipped.ok"), {"--milestone", "action"}).status, 0);
  EXPECT_TRUE(pixels() != action);
}

TEST_F(RealtimeProgram, EachOptionReachesThePicture) {
  const std::string scene = fixture("realtime.light-skipped");
  if (const ProgramRun run = render(scene, {}); !has_gl(run)) {
    GTEST_SKIP() << run.err;
  }
  const std::string plain = pixels();
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--parameters", "9,5"},
                                               {"--parameters", "5,9"},
                                               {"--near", "2.7"},
                                               {"--far", "2.8"},
                                               {"--filter", "invert"},
                                               {"--filter", "grayscale"},
                                               {"--filter", "blur"},
                                               {"--filter", "sharpen"},
                                               {"--milestone", "action"}}) {
    ASSERT_EQ(render(scene, more).status, 0) << more[0];
    EXPECT_TRUE(pixels() != plain) << more[0] << ' ' << more[1];
  }
  ASSERT_EQ(render(scene, {"--parameters", "5,5", "--near", "0.1", "--far", "100", "--filter",
                           "none", "--milestone", "lights-camera", "--engine", "gl"})
                .status,
            0);
  EXPECT_TRUE(pixels() == plain) << "the defaults";
}

TEST_F(RealtimeProgram, InfoAndCheckFollowTheMilestone) {
  const std::string scene = fixture("realtime.light-skipped");
  const ProgramRun info = run_program({"info", scene, "--profile", "realtime"});
  EXPECT_THAT(info.out, HasSubstr("lights-camera: 1 light is used, 40 triangles"));
  EXPECT_THAT(info.out, HasSubstr("skipped lights: 1 (1 point)"));
  const rapidjson::Document json = parse_json(
      run_program({"info", scene, "--json", "--profile", "realtime", "--milestone", "action"}).out);
  EXPECT_EQ(json["realtime"]["lights_drawn"].GetInt(), 2);
  EXPECT_EQ(json["realtime"]["shape_triangles"].GetDouble(), 40);
  EXPECT_THAT(run_program({"check", scene, "--profile", "realtime"}).out,
              HasSubstr("[realtime.light-skipped]"));
  EXPECT_THAT(run_program({"check", scene, "--profile", "realtime", "--milestone", "action"}).out,
              Not(HasSubstr("[realtime.")));
  EXPECT_THAT(run_program({"check", scene}).out, Not(HasSubstr("[realtime.")));
}

TEST_F(RealtimeProgram, RejectsIncompatibleOptions) {
  const auto words = [](std::vector<std::string> more) {
    std::vector<std::string> result{"render", "a.xml", "-o", "b.png", "--profile", "realtime"};
    result.insert(result.end(), more.begin(), more.end());
    return result;
  };
  is_refused(words({"--engine", "trace"}), "leave --engine trace out");
  is_refused(words({"--features", "shadows"}), "leave --features out");
  is_refused(words({"--mode", "ray"}), "leave --mode out");
  is_refused(words({"--samples", "4"}), "leave --samples out");
  is_refused(words({"--threads", "2"}), "leave it out, or --profile realtime");
  is_refused(words({"--near", "5", "--far", "5"}), "--near must be less than --far");
  is_refused(words({"--near", "0"}), "not a depth above 0");
  is_refused(words({"--parameters", "5"}), "not two parameters such as 5,5");
  is_refused(words({"--parameters", "0,5"}), "from 1 to 1024");
  is_refused(words({"--filter", "invret"}), "did you mean invert?");
  is_refused(words({"--milestone", "actoin"}), "did you mean action?");
  is_refused(words({"--aov", "depth"}), "--aov");
  for (const std::vector<std::string>& option : {std::vector<std::string>{"--parameters", "5,5"},
                                                 {"--near", "1"},
                                                 {"--far", "9"},
                                                 {"--filter", "none"},
                                                 {"--milestone", "action"}}) {
    is_refused({"render", "a.xml", "-o", "b.png", option[0], option[1]},
               option[0] + " is for --profile realtime");
  }
  is_refused({"diff", "a.png", "b.png", "--parameters", "5,5"},
             "--parameters is for --profile realtime");
}

// Pictures of a scene with round shapes, below folders as students have them.
struct RealtimePictures : RealtimeProgram {
  ProgramRun draw(const std::string& to, std::vector<std::string> more) const {
    std::vector<std::string> words{"render", scene,     "-o",        folder.path(to),
                                   "--size", "256x192", "--profile", "realtime"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words);
  }
  const std::string scene = std::string(SCENEFILE_FIXTURES) + "/../student/scenes/still-life.xml";
};

TEST_F(RealtimePictures, DiffNamesTheCause) {
  const ProgramRun drawn = draw("right.png", {"--parameters", "3,6", "--milestone", "action"});
  if (!has_gl(drawn)) {
    GTEST_SKIP() << drawn.err;
  }
  ASSERT_EQ(draw("wrong.png", {"--parameters", "6,3", "--milestone", "action"}).status, 0);
  const ProgramRun run =
      run_program({"diff", folder.path("right.png"), folder.path("wrong.png"), "--scene", scene,
                   "--profile", "realtime", "--parameters", "3,6", "--milestone", "action"});
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_THAT(run.out, HasSubstr("[tessellation]"));
  EXPECT_THAT(run.out, HasSubstr("the two are swapped"));
  EXPECT_THAT(run.out, HasSubstr("reference: as drawn with --profile realtime --parameters 3,6 "
                                 "--milestone action"));
  const std::size_t at = run.out.find("--pixel ");
  ASSERT_NE(at, run.out.npos) << run.out;
  const std::string pixel = run.out.substr(at + 8, run.out.find(' ', at + 8) - at - 8);
  const ProgramRun explained =
      run_program({"explain", scene, "--pixel", pixel, "--reference", folder.path("right.png"),
                   "--mine", folder.path("wrong.png"), "--profile", "realtime"});
  EXPECT_EQ(explained.status, 0) << explained.err;
  EXPECT_THAT(explained.out, HasSubstr("the two are swapped"));
  EXPECT_THAT(explained.out, HasSubstr("as yours"));
}

TEST_F(RealtimePictures, GradeReportsErrorsInTheTableOfSettings) {
  folder.write("references/references.tsv",
               "reference\tparameter1\tfilter\naction/still_blur.png\t5\tblurr\n");
  folder.write("class/readme.txt", "");
  const ProgramRun run =
      run_program({"grade", folder.path("class"), "--references", folder.path("references")});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("line 2: unknown filter blurr"));
}

}  // namespace

}  // namespace scenefile
