#include "scenefile/verbs/grade_paths.h"

#include "io/temp_folder.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/path/lamps.h"
#include "scenefile/path/render_path.h"
#include "scenefile/verbs/explain.h"
#include "scenefile/verbs/grade_class.h"
#include "scenefile/verbs/load_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

namespace scenefile {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* room = R"(<scenefile>
<globaldata><ambientcoeff v="0.5"/><diffusecoeff v="0.5"/><specularcoeff v="0.5"/></globaldata>
<cameradata><pos x="0" y="1" z="3.4"/><look x="0" y="0" z="-1"/><up x="0" y="1" z="0"/>
<heightangle v="40"/></cameradata>
<object type="tree" name="root"><transblock>
<object type="primitive" name="mesh" filename="room.obj"/></transblock></object></scenefile>)";

// A room with an open front, and a lamp below the ceiling.
constexpr const char* walls = R"(mtllib room.mtl
v -1 0 -1
v 1 0 -1
v 1 2 -1
v -1 2 -1
v -1 0 1
v 1 0 1
v 1 2 1
v -1 2 1
v -.3 1.9 -.3
v .3 1.9 -.3
v .3 1.9 .3
v -.3 1.9 .3
usemtl white
f 1 2 3 4
f 1 5 6 2
f 4 3 7 8
usemtl red
f 1 4 8 5
usemtl green
f 2 6 7 3
usemtl lamp
f 9 10 11 12
)";

constexpr const char* materials =
    "newmtl white\nKd .7 .7 .7\nnewmtl red\nKd .6 .1 .1\n"
    "newmtl green\nKd .1 .5 .1\nnewmtl lamp\nKe 8 8 8\n";

constexpr const char* config =
    "[IO]\nscene = room.xml\noutput = out/final/%.png\n"
    "[Settings]\nimageWidth = 64\nimageHeight = 64\n"
    "samplesPerPixel = 50\npathContinuationProb = 0.9\n"
    "directLightingOnly = @\nnumDirectLightingSamples = 1\n";

class GradePaths : public testing::Test {
 protected:
  void SetUp() override {
    write("room.xml", room);
    write("room.obj", walls);
    write("room.mtl", materials);
    write("inis/full.ini", configured("full", "false"));
    write("inis/direct.ini", configured("direct", "true"));
    write("inis/ray.ini", "[IO]\nscene=a.xml\noutput=a.png\n[Canvas]\nwidth=8\nheight=8\n");
    LoadSettings settings;
    settings.materials = true;
    scene_ = load_scene_file(path("room.xml"), settings);
  }

  static std::string configured(const std::string& name, const std::string& direct) {
    std::string text = config;
    text.replace(text.find('%'), 1, name);
    text.replace(text.find('@'), 1, direct);
    return text;
  }

  std::string path(const std::string& name) const { return folder_.path(name); }
  void write(const std::string& name, const std::string& bytes) const {
    folder_.write(name, bytes);
  }

  static RenderOptions options() {
    RenderOptions options = default_options(Profile::fine);
    options.mode = Mode::path;
    options.max_depth = path_max_depth;
    options.width = 64;
    options.height = 64;
    options.threads = 1;
    return options;
  }

  // A picture as a student hands it in.
  void hand_in(const std::string& name, bool direct_only, double factor = 1,
               std::uint32_t samples = 100) const {
    RenderOptions drawn = options();
    drawn.samples = samples;
    drawn.seed = 7;
    drawn.direct_only = direct_only;
    PathResult result = render_path(scene_.ready.scene, scene_.assets, drawn);
    ASSERT_EQ(result.status, RenderStatus::complete);
    for (float& value : result.image.rgb) {
      value *= static_cast<float>(value < 7 ? factor : 1);  // not of the lamp
    }
    const Result<std::string> bytes =
        encode_image(result.image, ImageFormat::pfm, Rounding::nearest);
    ASSERT_TRUE(bytes);
    write(name, *bytes);
  }

  Gradebook grade(double seconds = 1) const {
    GradeRequest request;
    request.handed_in = path("class");
    request.references = path("inis");
    request.scenes = path("");
    request.thumbnails = true;
    request.path = options();
    request.seconds = seconds;
    Result<Gradebook> book = grade_class(request, [&](const std::string&) { return scene_; });
    EXPECT_TRUE(book) << (book ? "" : book.error().text);
    return book ? *std::move(book) : Gradebook();
  }

  testing_support::TempFolder folder_;
  LoadedScene scene_;
};

TEST_F(GradePaths, ReadsConfigurations) {
  std::vector<std::string> notes;
  write("inis/other.ini", "[Other]\na=0\n");
  const Result<std::vector<PathReference>> found =
      path_references(path("inis"), "", options(), notes);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 2u);
  ASSERT_EQ(notes.size(), 1u);  // of the one that is skipped
  EXPECT_THAT(notes[0], HasSubstr("other.ini: not a configuration"));
  EXPECT_EQ(found->front().file.stem, "direct");
  EXPECT_EQ(found->front().file.folders.back(), "final");
  EXPECT_TRUE(found->front().options.direct_only);
  EXPECT_FALSE(found->back().options.direct_only);
  EXPECT_EQ(found->back().options.width, 64);
  EXPECT_EQ(found->back().scene, "room.xml");
  write("none/ray.ini", "[IO]\nscene=a.xml\noutput=a.png\n[Canvas]\nwidth=8\nheight=8\n");
  EXPECT_FALSE(path_references(path("none"), "", options(), notes));
  write("broken/a.ini", "[IO]\nscene = room.xml\n[Settings]\nimageWidth = 64\n");
  const Result<std::vector<PathReference>> broken =
      path_references(path("broken"), "", options(), notes);
  ASSERT_FALSE(broken);
  EXPECT_THAT(broken.error().text, HasSubstr("a.ini"));
  EXPECT_THAT(broken.error().text, Not(HasSubstr("a.ini:0")));
  std::string absolute = configured("full", "false");
  absolute.insert(absolute.find("room.xml"), "/");
  write("absolute/a.ini", absolute);
  EXPECT_EQ(path_references(path("absolute"), "b", options(), notes)->front().scene, "/room.xml");
  notes.clear();
  write("typo/a.ini", configured("full", "false") + "directLigthingOnly = true\n");
  ASSERT_TRUE(path_references(path("typo"), "", options(), notes));
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_THAT(notes[0], HasSubstr("a.ini:11: unknown key [Settings] directLigthingOnly"));
  write("twice/a.ini", configured("full", "false"));
  write("twice/b.ini", configured("full", "true"));
  const Result<std::vector<PathReference>> twice =
      path_references(path("twice"), "", options(), notes);
  ASSERT_FALSE(twice);
  EXPECT_THAT(twice.error().text, HasSubstr("b.ini name the same output, \"out/final/full.png\""));
}

TEST_F(GradePaths, JudgesPicturesWithinTheirNoise) {
  ASSERT_TRUE(scene_.usable());
  hand_in("class/ada/full.pfm", false);
  hand_in("class/ada/direct.pfm", true);
  hand_in("class/ben/full.pfm", true);  // indirect light is missing
  hand_in("class/ben/direct.pfm", true, 0.5);
  write("class/cleo/full.pfm", "no picture");
  write("inis/other.ini", "[Other]\na=0\n");
  const Gradebook book = grade();
  ASSERT_EQ(book.students.size(), 3u);
  const auto& [ada, ben, cleo] = std::tie(book.students[0], book.students[1], book.students[2]);
  for (const PictureResult& picture : ada.pictures) {
    EXPECT_EQ(picture.verdict, Verdict::passed) << picture.name;
    EXPECT_TRUE(picture.path_traced);
    EXPECT_FALSE(picture.png.empty());
  }
  const PictureResult& halved = ben.pictures[0];
  EXPECT_EQ(halved.name, "direct");
  ASSERT_FALSE(halved.causes.empty());
  EXPECT_EQ(halved.causes.front().cause, Cause::light_samples);
  const PictureResult& direct = ben.pictures[1];
  EXPECT_EQ(direct.verdict, Verdict::differs);
  ASSERT_FALSE(direct.causes.empty());
  EXPECT_EQ(direct.causes.front().cause, Cause::path_length);
  EXPECT_THAT(direct.causes.front().what, HasSubstr("indirect light is missing"));
  EXPECT_EQ(cleo.pictures[0].verdict, Verdict::missing);
  EXPECT_EQ(cleo.pictures[1].verdict, Verdict::unreadable);
  const std::string json = gradebook_json(book);
  EXPECT_THAT(json, HasSubstr("path_traced"));
  EXPECT_THAT(json, HasSubstr("other.ini: not a configuration"));
  EXPECT_EQ(json.find("psnr_db"), std::string::npos);
  EXPECT_THAT(gradebook_csv(book), HasSubstr("\"ben\",\"full\",differs,64x64,64x64,,,"));
  EXPECT_THAT(gradebook_html(book, "Path"), HasSubstr("right within its noise"));
}

TEST_F(GradePaths, AMissingSceneIsAMissingFile) {
  write("class/ada/full.pfm", "");
  GradeRequest request;
  request.handed_in = path("class");
  request.references = path("inis");
  request.path = options();
  const Result<Gradebook> book =
      grade_class(request, [&](const std::string&) { return load_scene_file(path("none.xml")); });
  ASSERT_FALSE(book);
  EXPECT_EQ(book.error().kind, ErrorKind::environment);
}

TEST_F(GradePaths, NoisyVariantsAreDrawnAgainAsByDiff) {
  const LoadedScene right = scene_;
  write("room.obj", std::string(walls) + "f 12 11 10 9\n");  // the lamp's other side
  LoadSettings settings;
  settings.materials = true;
  scene_ = load_scene_file(path("room.xml"), settings);
  hand_in("class/ada/full.pfm", false, 1, 16);
  scene_ = right;
  const Result<DecodedPicture> mine = load_picture_file(path("class/ada/full.pfm"));
  ASSERT_TRUE(mine);
  constexpr double seconds = 2.5;
  PathTruth truth;
  ASSERT_EQ(draw_truth(scene_, options(), seconds, {}, truth), RenderStatus::complete);
  ASSERT_FALSE(truth.variants.empty());
  VariantPicture& two_sided = truth.variants.front();
  ASSERT_EQ(two_sided.variant, Variant::two_sided_lamps);
  for (Color& noise : two_sided.noise) {
    noise += Color(1);
  }
  PathVerdict verdict;
  int draws = 0;
  const auto judge = [&] {
    const Progress count = [&](double) { return ++draws > 0; };
    ASSERT_EQ(judge_by_truth(scene_, options(), seconds, count, *mine, truth, verdict),
              RenderStatus::complete);
  };
  judge();
  EXPECT_EQ(draws, 1);
  ASSERT_EQ(truth.finer_variants.size(), 1);
  EXPECT_GE(truth.variants.front().noise.front().x, 1);  // for other pictures
  const PathVerdict once = verdict;
  judge();
  EXPECT_EQ(draws, 1);
  EXPECT_EQ(verdict.chi2_per_value, once.chi2_per_value);
  // Other work slows a machine: then the truth needs more time.
  bool said = once.conventions.empty();
  for (double longer = 1.4; !said && longer < 12; longer *= 2) {
    const Gradebook book = grade(longer * seconds);
    ASSERT_EQ(book.students.size(), 1);
    const std::vector<std::string>& notes = book.students[0].pictures[1].notes;
    said = std::find(notes.begin(), notes.end(), no_mistake_text(once.conventions.front().what)) !=
           notes.end();
  }
  EXPECT_TRUE(said);
}

// None of several mistakes that give the same picture stands alone.
TEST_F(GradePaths, ACauseNamesThoseThatGiveTheSamePicture) {
  PathVerdict verdict;
  verdict.causes = {{Cause::scattering, "diffuse-color", "no Kd", "", 1},
                    {Cause::path_length, "roulette", "wrong roulette", "", 1}};
  PictureResult result;
  set_result(verdict, result);
  ASSERT_EQ(result.causes.size(), 1);
  EXPECT_THAT(result.causes[0].what, ::testing::HasSubstr("no Kd; or wrong roulette"));
  EXPECT_EQ(result.causes[0].alternatives.size(), 2);
  ASSERT_EQ(result.rivals.size(), 1);
  EXPECT_TRUE(result.rivals[0].said);
}

TEST_F(GradePaths, ThePixelsAroundOneAreComparedWithTheTruth) {
  hand_in("half.pfm", false, 0.5);
  const Result<DecodedPicture> mine = load_picture_file(path("half.pfm"));
  ASSERT_TRUE(mine);
  PathTruth truth;
  ASSERT_EQ(draw_truth(scene_, options(), 1, {}, truth), RenderStatus::complete);
  const PathNeighborhood floor = neighborhood(truth, judge_path(truth, *mine), {33, 60});
  EXPECT_EQ(floor.block, (PixelRegion{32, 56, 40, 64}));
  ASSERT_TRUE(floor.mine);
  EXPECT_NEAR(luminance(*floor.mine) / luminance(floor.truth), 0.5, 0.05);
  EXPECT_LT(floor.significance, -10);
  EXPECT_GT(floor.error, floor.truth_error);
  Color sum(0);
  for (const PathTerm& term : floor.terms) {
    sum += term.name.starts_with("of these") ? Color(0) : term.light;
  }
  EXPECT_LT(glm::length(sum - floor.truth), 1e-9);
  EXPECT_FALSE(floor.verdict.causes.empty());
}

}  // namespace
}  // namespace scenefile
