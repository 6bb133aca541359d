// scenefile diff for pictures, and scenefile grade.

#include "app/run_program.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/base/base64.h"
#include "support/jpeg_bytes.h"
#include "support/write_archive.h"

#ifdef __linux__
#include <sys/inotify.h>
#include <unistd.h>
#endif

#include <fmt/format.h>
#include <glm/glm.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <limits>
#include <set>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

// A picture, the same with twice the ambient light, and one of a different size.
struct Pictures : ProgramFolder {
  Pictures() {
    scene = folder.write("ball.xml", ball("0.2"));
    folder.write("brighter.xml", ball("0.4"));
    draw("ball.xml", "right.png", "64x48");
    draw("brighter.xml", "wrong.png", "64x48");
    draw("ball.xml", "small.png", "32x24");
  }

  static std::string ball(const std::string& ambient) {
    return scene_with("<ambient r=\"" + ambient + "\" g=\"" + ambient + "\" b=\"" + ambient +
                      "\"/> <diffuse r=\"1\" g=\"0.5\" b=\"0.2\"/>");
  }

  // Without symmetry.
  static std::string two_balls(const std::string& ambient) {
    std::string text = ball(ambient);
    const std::string more =
        "<transblock><translate x=\"0.7\" y=\"0.5\" z=\"0\"/><scale x=\"0.4\" y=\"0.5\" "
        "z=\"0.4\"/><object type=\"primitive\" name=\"cube\"><ambient r=\"" +
        ambient +
        "\" g=\"0\" b=\"0\"/><diffuse r=\"0\" g=\"0.4\" b=\"0.9\"/></object></transblock>";
    return text.insert(text.rfind("</object>"), more);
  }

  void draw(const std::string& from, const std::string& to, const std::string& size) const {
    const ProgramRun run =
        program({"render", from, "-o", to, "--size", size, "--profile", "course", "--quiet"});
    EXPECT_EQ(run.status, 0) << run.err;
  }

  void make_folders(const std::vector<std::string>& names) const {
    for (const std::string& name : names) {
      std::filesystem::create_directories(folder.path(name));
    }
  }

  std::string scene;
};

// What grade says if it finds no scenes.
constexpr std::string_view no_scenes_note =
    "note: no reference has a scene: most mistakes cannot be named; --scenes DIR names the folder "
    "of the scenes\n";

using DiffImages = Pictures;
using Grade = Pictures;

TEST_F(DiffImages, EqualPictures) {
  const ProgramRun run = program({"diff", "right.png", "right.png"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.out, AllOf(HasSubstr("right.png and right.png: 64x48\n"),
                             HasSubstr("PSNR 99.00 dB"), HasSubstr("\nequal\n")));
  EXPECT_EQ(program({"diff", "-q", "right.png", "right.png"}).out, "");
}

TEST_F(DiffImages, TheCauseIsNamedWithAScene) {
  const ProgramRun alone = program({"diff", "right.png", "wrong.png"});
  EXPECT_EQ(alone.status, 1);
  EXPECT_THAT(alone.out, AllOf(HasSubstr("different: the pictures are not equal\n"),
                               Not(HasSubstr("[ambient]"))));
  const ProgramRun run = program({"diff", "right.png", "wrong.png", "--scene", "ball.xml"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(
      run.out,
      HasSubstr("cause: the ambient term is added twice; or the ambient term is missing the "
                "global coefficient: these give the same picture [ambient]\n"));
  EXPECT_EQ(run.err, "");
}

TEST_F(DiffImages, WithoutAReferenceItSaysHowToDrawIt) {
  const ProgramRun run = program({"diff", "wrong.png", "--scene", "ball.xml"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("scenefile render ball.xml --profile course --size 64x48 -o "
                                 "reference.png (a path-traced picture"));
}

TEST_F(DiffImages, JpegsOfRightPicturesAreSaidToBeSo) {
  const auto said_of_jpeg = [&](const std::string& from) {
    draw(from, "full.png", "320x240");
    const auto picture = decode_image(folder.read("full.png"));
    folder.write("mine.jpg", testing_support::jpeg_of(*picture, 75));
    draw("ball.xml", "full.png", "320x240");
    return program({"diff", "full.png", "mine.jpg", "--scene", "ball.xml"}).out;
  };
  EXPECT_THAT(said_of_jpeg("ball.xml"), AllOf(HasSubstr("cause: none"), HasSubstr("of JPEGs")));
  EXPECT_THAT(said_of_jpeg("brighter.xml"), Not(HasSubstr("of JPEGs")));
}

TEST_F(DiffImages, FloatsCompareAsLinearValues) {
  draw("ball.xml", "a.exr", "64x48");
  draw("ball.xml", "a.pfm", "64x48");
  draw("brighter.xml", "b.exr", "64x48");
  EXPECT_THAT(program({"diff", "a.pfm", "a.pfm"}).out, HasSubstr("equal"));
#if SCENEFILE_OPENEXR
  EXPECT_THAT(program({"diff", "a.exr", "a.pfm"}).out, HasSubstr("\nequal\n"));
  const ProgramRun run = program({"diff", "a.exr", "b.exr", "--json"});
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(parse_json(run.out)["linear"].GetBool());
  EXPECT_THAT(program({"diff", "a.exr", "b.exr"}).out, HasSubstr("  linear values:\n"));
  EXPECT_EQ(program({"diff", "a.exr", "b.exr", "--max-difference", "254.5"}).status, 0);
#endif
}

TEST_F(DiffImages, FloatsEqualTheirOwnPng) {
  for (const char* profile : {"fine", "course"}) {
    for (const char* name : {"a.png", "a.pfm", "a.exr"}) {
      ASSERT_EQ(program({"render", "ball.xml", "--size", "64x48", "--profile", profile, "-o", name})
                    .status,
                0);
    }
    for (const char* name : {"a.pfm", "a.exr"}) {
      if (!SCENEFILE_OPENEXR && std::string_view(name) == "a.exr") {
        continue;
      }
      EXPECT_THAT(program({"diff", "a.png", name}).out, HasSubstr("\nequal\n")) << profile;
      EXPECT_THAT(program({"diff", name, "a.png"}).out, HasSubstr("\nequal\n")) << profile;
    }
  }
}

TEST_F(DiffImages, FloatsMayDifferWhereBytesDoNot) {
  Image image(20, 20);
  std::fill(image.rgb.begin(), image.rgb.end(), 1.5f);
  folder.write("a.pfm", *encode_image(image, ImageFormat::pfm, Rounding::nearest));
  image.rgb[0] = 3;
  folder.write("b.pfm", *encode_image(image, ImageFormat::pfm, Rounding::nearest));
  const ProgramRun run = program({"diff", "a.pfm", "b.pfm"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.out, AllOf(HasSubstr("different: the pictures are not equal"),
                             HasSubstr("maximum 382.5/255"),
                             HasSubstr("as 8-bit pictures, both are equal")));
  image.rgb[0] = std::numeric_limits<float>::quiet_NaN();
  folder.write("b.pfm", *encode_image(image, ImageFormat::pfm, Rounding::nearest));
  const ProgramRun nan = program({"diff", "a.pfm", "b.pfm"});
  EXPECT_EQ(nan.status, 1);
  EXPECT_THAT(nan.out, AllOf(HasSubstr("b.pfm: 1 of its pixels is not finite (NaN or infinite)"),
                             HasSubstr("maximum 255/255"), Not(HasSubstr("nan"))));
  EXPECT_THAT(program({"diff", "b.pfm", "b.pfm"}).out, HasSubstr("equal"));
}

#if SCENEFILE_OPENEXR
TEST_F(DiffImages, LayersOfExrAreChosen) {
  ASSERT_EQ(
      program({"render", "ball.xml", "--size", "64x48", "--aov", "normal,depth", "-o", "a.exr"})
          .status,
      0);
  EXPECT_THAT(program({"diff", "a.exr", "a.exr", "--layer", "normal"}).out, HasSubstr("equal"));
  const ProgramRun none = program({"diff", "a.exr", "right.png", "--layer", "glossy"});
  EXPECT_EQ(none.status, 1);
  EXPECT_EQ(none.err,
            "scenefile: a.exr: cannot decode: EXR of 64 x 48 pixels: it has no layer "
            "\"glossy\"; it has depth, normal\n");
  EXPECT_EQ(program({"explain", "ball.xml", "--pixel", "3,3", "--mine", "a.exr"}).status, 0);
}
#endif

TEST_F(DiffImages, OtherFilesGetOneLine) {
  folder.write("notes.txt", "secret: 42\nmore\n");
  folder.write("empty.png", "");
  folder.write("text.png", "secret: 43");
  const std::string formats = "(PNG, JPEG, GIF, BMP, PPM, PFM, EXR, TGA)\n";
  const auto error = [&](const std::vector<std::string>& arguments) {
    const ProgramRun run = program(arguments);
    EXPECT_NE(run.status, 0);
    EXPECT_EQ(run.out, "");
    return run.err;
  };
  EXPECT_EQ(error({"diff", "right.png", "notes.txt"}),
            "scenefile: notes.txt: not a picture that scenefile reads " + formats);
  EXPECT_EQ(error({"diff", "right.png", "text.png"}),
            "scenefile: text.png: not a picture that scenefile reads " + formats);
  EXPECT_EQ(error({"diff", "text.png", "empty.png"}),
            "scenefile: text.png: not a picture that scenefile reads " + formats +
                "scenefile: empty.png: the file is empty\n");
  EXPECT_EQ(error({"explain", "ball.xml", "--pixel", "1,1", "--mine", "notes.txt"}),
            "scenefile: notes.txt: not a picture that scenefile reads " + formats);
  EXPECT_EQ(error({"explain", "ball.xml", "--pixel", "1,1", "--mine", "ball.xml"}),
            "scenefile: ball.xml is a scene, not a picture\n");
}

TEST_F(DiffImages, AnUnusableSceneIsAnError) {
  for (const std::string second : {"right.png", "wrong.png"}) {
    const ProgramRun run = program({"diff", "right.png", second, "--scene", "none.xml"});
    EXPECT_EQ(run.status, 3);
    EXPECT_THAT(run.err, HasSubstr("none.xml: cannot open"));
    EXPECT_EQ(run.out, "");
  }
  folder.write("broken.xml", "<scenefile>");
  const ProgramRun broken = program({"diff", "right.png", "right.png", "--scene", "broken.xml"});
  EXPECT_EQ(broken.status, 1);
  EXPECT_THAT(broken.err, HasSubstr("broken.xml:1:12: error: "));
  EXPECT_EQ(broken.out, "");
  const ProgramRun json =
      program({"diff", "--json", "right.png", "right.png", "--scene", "none.xml"});
  EXPECT_EQ(json.status, 3);
  EXPECT_THAT(parse_json(json.out)["scene"]["error"].GetString(),
              HasSubstr("none.xml: cannot open"));
}

TEST_F(DiffImages, SuggestsASceneIfNoneIsGiven) {
  const ProgramRun alone = program({"diff", "right.png", "wrong.png"});
  EXPECT_THAT(alone.out, HasSubstr("most causes need --scene SCENE"));
  const ProgramRun with = program({"diff", "right.png", "wrong.png", "--scene", "ball.xml"});
  EXPECT_THAT(with.out, Not(HasSubstr("--scene SCENE")));
}

TEST_F(DiffImages, ThresholdsDecide) {
  EXPECT_EQ(program({"diff", "right.png", "wrong.png", "--min-psnr", "5"}).status, 0);
  EXPECT_EQ(program({"diff", "right.png", "wrong.png", "--min-psnr", "60"}).status, 1);
  EXPECT_EQ(program({"diff", "right.png", "wrong.png", "--max-share", "100"}).status, 0);
  EXPECT_EQ(program({"diff", "right.png", "wrong.png", "--max-flip", "0.0001"}).status, 1);
  const ProgramRun bad = program({"diff", "right.png", "wrong.png", "--min-ssim", "2"});
  EXPECT_EQ(bad.status, 2);
  EXPECT_THAT(bad.err, HasSubstr("--min-ssim: \"2\" is not a number from 0 to 1"));
}

TEST_F(DiffImages, WritesMaps) {
  EXPECT_EQ(program({"diff", "right.png", "wrong.png", "--heatmap", "heat.png", "--sheet",
                     "sheet.png", "-q"})
                .status,
            1);
  EXPECT_EQ(decode_image(folder.read("heat.png"))->width, 64);
  EXPECT_EQ(decode_image(folder.read("sheet.png"))->width, 4 * 64 + 5 * 8);
  EXPECT_EQ(program({"diff", "right.png", "wrong.png", "--sheet", "right.png"}).status, 2);
  EXPECT_EQ(program({"diff", "right.png", "wrong.png", "--sheet", "sheet.gif"}).status, 2);
  folder.write("scene.png", ball("0.2"));  // the type is determined by the content, not by the name
  const ProgramRun scene_lost =
      program({"diff", "right.png", "wrong.png", "--scene", "scene.png", "--sheet", "./scene.png"});
  EXPECT_EQ(scene_lost.status, 2);
  EXPECT_THAT(scene_lost.err, HasSubstr("the sheet ./scene.png would replace the scene scene.png"));
  const ProgramRun alike =
      program({"diff", "right.png", "wrong.png", "--sheet", "both.png", "--heatmap", "./both.png"});
  EXPECT_EQ(alike.status, 2);
  EXPECT_THAT(alike.err, HasSubstr("the sheet both.png would replace the heat map ./both.png"));
}

TEST_F(DiffImages, ExchangedPicturesAreSaid) {
  for (const char* name : {"near", "bright"}) {
    std::string text = ball(name == std::string("near") ? "0.2" : "0.4");
    text.replace(text.find("v=\"40\""), 6, "v=\"20\"");
    folder.write(std::string(name) + ".xml", text);
    draw(std::string(name) + ".xml", std::string(name) + ".png", "64x48");
  }
  const ProgramRun run =
      program({"diff", "bright.png", "near.png", "--scene", "near.xml", "--json"});
  EXPECT_EQ(run.status, 1);
  const rapidjson::Document answer = parse_json(run.out);
  EXPECT_TRUE(answer["exchanged"].GetBool());
  EXPECT_TRUE(answer["causes"].Empty());
  EXPECT_FALSE(answer.HasMember("worst"));
  EXPECT_THAT(
      program({"diff", "bright.png", "near.png", "--scene", "near.xml"}).out,
      AllOf(EndsWith("\nthe second picture shows the scene, and the first does not: give the "
                     "reference first\n")));
}

TEST_F(DiffImages, AnExchangedPictureThatIsMostlyRight) {
  const auto said = [&](const char* first, const char* second) {
    return program({"diff", first, second, "--scene", "ball.xml"}).out;
  };
  EXPECT_THAT(said("wrong.png", "right.png"), EndsWith("give the reference first\n"));
  // Both right: the reference has several samples per pixel.
  program({"render", "ball.xml", "-o", "smooth.png", "--size", "64x48", "--profile", "course",
           "--features", "shadows,reflect,refract,texture,super-sample", "--quiet"});
  EXPECT_THAT(said("smooth.png", "right.png"), Not(HasSubstr("give the reference first")));
}

TEST_F(DiffImages, NoObjectIsNamedInAnotherScene) {
  std::string text = ball("0.2");
  text.replace(text.find("v=\"40\""), 6, "v=\"12\"");
  folder.write("near.xml", text);
  EXPECT_THAT(
      program({"diff", "right.png", "wrong.png", "--scene", "near.xml"}).out,
      AllOf(HasSubstr("the scene does not match the reference"), HasSubstr("worst: "),
            HasSubstr("look at pixel "), Not(HasSubstr("it shows")), Not(HasSubstr("try:"))));
}

TEST_F(DiffImages, TheCommandToTryDrawsTheSamePicture) {
  EXPECT_THAT(
      program({"diff", "right.png", "wrong.png", "--scene", "ball.xml", "--profile", "course",
               "--features", "texture,shadows", "--max-depth", "2", "--asset-root", "."})
          .out,
      HasSubstr(" --reference right.png --mine wrong.png --profile course --features "
                "texture,shadows --max-depth 2 --asset-root .\n"));
  EXPECT_THAT(program({"diff", "right.png", "wrong.png", "--scene", "ball.xml", "--profile", "fine",
                       "--features", "intersect"})
                  .out,
              HasSubstr("as drawn with --profile fine --features intersect\n"));
}

TEST_F(DiffImages, ExplainSaysWhatDiffSays) {
  const std::string said = program({"diff", "right.png", "wrong.png", "--scene", "ball.xml"}).out;
  const std::size_t start = said.find("--pixel ") + 8;
  Words words{
      "explain",     "ball.xml",  "--pixel", said.substr(start, said.find(' ', start) - start),
      "--reference", "right.png", "--mine",  "wrong.png"};
  const std::string explained = program(words).out;
  const std::size_t cause = said.find("cause: ");
  ASSERT_NE(cause, std::string::npos) << said;
  EXPECT_THAT(explained,
              AllOf(HasSubstr(said.substr(cause, said.find('\n', cause) - cause)),
                    HasSubstr("ours with this mistake = "), HasSubstr("as yours"),
                    HasSubstr("reference: as drawn with "), HasSubstr("profile course")));
  words.emplace_back("--json");
  const rapidjson::Document document = parse_json(program(words).out);
  EXPECT_TRUE(document["pixel"]["yours"]["compared"]["explained"].GetBool());
  EXPECT_THAT(program({"explain", "ball.xml", "--pixel", "1,1", "--reference", "right.png"}).err,
              HasSubstr("--reference needs your picture: --mine PICTURE"));
  EXPECT_THAT(program({"explain", "ball.xml", "--pixel", "1,1", "--reference", "right.png",
                       "--mine", "wrong.png", "--size", "64x48"})
                  .err,
              HasSubstr("the pictures determine the size"));
}

TEST_F(DiffImages, AReferenceIsSaidToBeDrawnWithItsSamples) {
  const std::string features = "shadows,reflect,refract,texture,super-sample";
  program({"render", "ball.xml", "-o", "many.png", "--size", "64x48", "--profile", "course",
           "--features", features, "--quiet"});
  const std::string said = program({"diff", "many.png", "wrong.png", "--scene", "ball.xml"}).out;
  EXPECT_THAT(said, HasSubstr("reference: as drawn with --profile course --features all\n"));
  const auto picture = decode_image(folder.read("right.png"));
  folder.write("right.jpg", jpeg_of(*picture, 60));
  EXPECT_THAT(program({"diff", "right.jpg", "wrong.png", "--scene", "ball.xml"}).out,
              HasSubstr("reference: nearly as drawn with --profile course"));
}

// The other features do not show, so all of them draw the same.
TEST_F(DiffImages, TheReferenceIsTheSameForTwoPictures) {
  program({"render", "ball.xml", "-o", "fine.png", "--size", "64x48", "--quiet"});
  program({"render", "brighter.xml", "-o", "other.png", "--size", "64x48", "--quiet"});
  for (const char* picture : {"wrong.png", "other.png", "right.png"}) {
    EXPECT_THAT(program({"diff", "fine.png", picture, "--scene", "ball.xml"}).out,
                HasSubstr("reference: as drawn with --profile fine\n"))
        << picture;
  }
}

TEST_F(DiffImages, OtherSizesAndFiles) {
  const ProgramRun sizes = program({"diff", "right.png", "small.png", "--min-psnr", "0"});
  EXPECT_EQ(sizes.status, 1);
  EXPECT_THAT(sizes.out,
              AllOf(HasSubstr("64x48 and 32x24"),
                    HasSubstr("the size is 32x24, expected 64x48; compared after scaling"),
                    HasSubstr("PSNR ")));
  EXPECT_FALSE(
      parse_json(program({"diff", "right.png", "small.png", "--json"}).out)["same_size"].GetBool());
  const ProgramRun cause =
      program({"diff", "small.png", "wrong.png", "--scene", "ball.xml", "--heatmap", "map.png"});
  EXPECT_THAT(
      cause.out,
      AllOf(HasSubstr("expected 32x24; compared with our picture of the scene at that size"),
            HasSubstr("cause: the ambient term is added twice"),
            HasSubstr(" --reference small.png --mine wrong.png\n")));
  EXPECT_TRUE(std::filesystem::exists(folder.path("map.png")));
  draw("ball.xml", "tall.png", "32x48");
  const ProgramRun shape =
      program({"diff", "right.png", "tall.png", "--scene", "ball.xml", "--json"});
  EXPECT_EQ(shape.status, 1);
  const rapidjson::Document answer = parse_json(shape.out);
  EXPECT_TRUE(answer["reference_redrawn"].GetBool());
  EXPECT_TRUE(answer["right_at_other_size"].GetBool());
  EXPECT_EQ(answer["max_difference"].GetInt(), 0);
  EXPECT_FALSE(answer["exchanged"].GetBool());
  EXPECT_THAT(program({"diff", "right.png", "tall.png"}).out,
              HasSubstr("the size is 32x48, expected 64x48\n"));
  EXPECT_EQ(program({"diff", "right.png", "none.png"}).status, 3);
  folder.write("text.png", "no picture");
  const ProgramRun text = program({"diff", "right.png", "text.png"});
  EXPECT_EQ(text.status, 1);
  EXPECT_THAT(text.err, HasSubstr("text.png: not a picture"));
}

TEST_F(DiffImages, AFolderOfTheCourseDecidesBetweenEqualFeatures) {
  std::filesystem::create_directories(folder.path("grading_illuminate"));
  folder.write("grading_illuminate/ball.png", folder.read("right.png"));
  const auto said = [&](const char* reference) {
    return program({"diff", reference, "wrong.png", "--scene", "ball.xml"}).out;
  };
  EXPECT_THAT(said("right.png"), HasSubstr("reference: as drawn with --profile course\n"));
  EXPECT_THAT(said("grading_illuminate/ball.png"),
              HasSubstr("reference: as drawn with --profile course --features illuminate\n"));
}

// In the reference, the ball is below the floor, so that shadows and reflections do not show.
TEST_F(DiffImages, APictureWithoutFeaturesThatTheReferenceDoesNotShow) {
  const auto floor_and_ball = [](const char* angle) {
    return std::string(R"(<scenefile>
<globaldata><ambientcoeff v="1"/><diffusecoeff v="1"/><specularcoeff v="1"/></globaldata>
<cameradata><pos x="1" y="3" z="6"/><focus x="0" y="0.3" z="0"/><up x="0" y="1" z="0"/>
<heightangle v="40"/></cameradata>
<lightdata><type v="directional"/><color r="1" g="1" b="1"/><direction x="1" y="-2" z="-1"/></lightdata>
<object type="tree" name="root"><transblock><scale x="6" y="0.1" z="6"/>
<object type="primitive" name="cube"><ambient r="0.1" g="0.1" b="0.1"/>
<diffuse r="0.5" g="0.6" b="0.7"/><reflective r="0.5" g="0.5" b="0.5"/></object></transblock>
<transblock><rotate x="0" y="0" z="1" angle=")") +
           angle + R"("/><translate x="1.5" y="0" z="0"/>
<object type="primitive" name="sphere"><ambient r="0.2" g="0.1" b="0.1"/>
<diffuse r="0.9" g="0.4" b="0.3"/></object></transblock></object></scenefile>)";
  };
  folder.write("below.xml", floor_and_ball("-50"));
  folder.write("above.xml", floor_and_ball("50"));
  draw("below.xml", "below.png", "160x120");
  program({"render", "above.xml", "-o", "above.png", "--size", "160x120", "--profile", "course",
           "--features", "none", "--quiet"});
  EXPECT_THAT(
      program({"diff", "below.png", "above.png", "--scene", "below.xml"}).out,
      AllOf(HasSubstr("\ncause: rotations turn the wrong way [transforms]\n       simulating"),
            HasSubstr("\n note: the picture is drawn with --profile course --features none; "
                      "the reference looks the same with it; this is not a mistake"),
            HasSubstr("reference: as drawn with --profile course\n")));
}

// The picture on a gray one, or the part of it that is visible there.
void show_at(const TempFolder& folder, const char* from, const char* to, const glm::ivec2& corner,
             const glm::ivec2& size) {
  const Texture picture = *decode_image(folder.read(from));
  Image shown(size.x, size.y);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const glm::ivec2 p = glm::ivec2(x, y) - corner;
      const bool inside = p.x >= 0 && p.y >= 0 && p.x < picture.width && p.y < picture.height;
      for (int c = 0; c < 3; ++c) {
        shown.pixel(x, y)[c] = inside ? static_cast<float>(picture.texel(p.x, p.y)[c]) / 255 : 0.9F;
      }
    }
  }
  folder.write(to, *encode_image(shown, ImageFormat::png8, Rounding::nearest));
}

TEST_F(DiffImages, ThePartThatShowsTheSceneIsCompared) {
  folder.write("two.xml", two_balls("0.2"));
  folder.write("bright.xml", two_balls("0.4"));
  draw("two.xml", "whole.png", "160x120");
  draw("bright.xml", "mine.png", "160x120");
  show_at(folder, "mine.png", "window.png", {7, 21}, {180, 150});
  const ProgramRun window =
      program({"diff", "whole.png", "window.png", "--scene", "two.xml", "--profile", "course"});
  EXPECT_EQ(window.status, 1);
  EXPECT_THAT(
      window.out,
      AllOf(HasSubstr("the size is 180x150, expected 160x120; compared its part at 7,21 of "
                      "size 160x120, with the reference\n"),
            HasSubstr("cause: the ambient term is added twice"), HasSubstr("worst: 61,37..")));
  show_at(folder, "mine.png", "cut.png", {-9, -4}, {140, 110});
  const ProgramRun cut = program(
      {"diff", "whole.png", "cut.png", "--scene", "two.xml", "--profile", "course", "--json"});
  const rapidjson::Document answer = parse_json(cut.out);
  ASSERT_TRUE(answer.HasMember("place"));
  EXPECT_EQ(answer["place"]["x"].GetInt(), -9);
  EXPECT_EQ(answer["place"]["y"].GetInt(), -4);
  EXPECT_EQ(answer["place"]["width"].GetInt(), 160);
  EXPECT_STREQ(answer["causes"][0]["cause"].GetString(), "ambient");
  EXPECT_STREQ(answer["broken"][0].GetString(),
               "the size is 140x110, expected 160x120; compared with the part at 9,4 of the "
               "reference");
  show_at(folder, "whole.png", "right-window.png", {7, 21}, {180, 150});
  EXPECT_THAT(program({"diff", "whole.png", "right-window.png", "--scene", "two.xml"}).out,
              HasSubstr("cause: none; the part that was compared is right\n"));
}

TEST_F(DiffImages, ASceneIsNotAPicture) {
  const std::string words =
      "scenefile: ball.xml is a scene and right.png a picture; compare two scenes, or two pictures";
  for (const auto& [first, second] :
       {std::pair("right.png", "ball.xml"), {"ball.xml", "right.png"}}) {
    const ProgramRun mixed = program({"diff", first, second});
    EXPECT_EQ(mixed.status, 1);
    EXPECT_THAT(mixed.err, HasSubstr(words));
    EXPECT_EQ(mixed.out, "");
  }
}

#ifdef __linux__
// How often a file is opened while the program runs.
int times_opened(const TempFolder& folder, const std::string& name, const Words& words) {
  const int watch = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  EXPECT_GE(::inotify_add_watch(watch, folder.path(name).c_str(), IN_OPEN), 0);
  run_program(words, {.folder = folder.path()});
  int opened = 0;
  inotify_event event{};
  while (::read(watch, &event, sizeof event) == static_cast<ssize_t>(sizeof event)) {
    ++opened;
  }
  ::close(watch);
  return opened;
}

TEST_F(DiffImages, ReadsEachPictureOnce) {
  for (const Words& words : {Words{"diff", "right.png", "wrong.png"},
                             {"diff", "right.png", "wrong.png", "--scene", "ball.xml"},
                             {"diff", "ball.xml", "wrong.png"}}) {
    EXPECT_EQ(times_opened(folder, "wrong.png", words), 1) << words.size();
  }
  EXPECT_EQ(times_opened(folder, "ball.xml", {"diff", "ball.xml", "wrong.png"}), 1);
}
#endif

TEST_F(DiffImages, NamesTheWorstRegion) {
  const ProgramRun run = program({"diff", "right.png", "wrong.png", "--scene", "ball.xml"});
  EXPECT_THAT(run.out, AllOf(HasSubstr("worst: "), HasSubstr("it shows root"),
                             HasSubstr("try: scenefile explain ball.xml --pixel "),
                             HasSubstr(" --reference right.png --mine wrong.png")));
  EXPECT_THAT(program({"diff", "right.png", "wrong.png"}).out, HasSubstr("look at pixel "));
  const rapidjson::Document document =
      parse_json(program({"diff", "--json", "right.png", "wrong.png", "--scene", "ball.xml"}).out);
  const auto& worst = document["worst"];
  EXPECT_LE(worst["x0"].GetInt(), worst["x"].GetInt());
  EXPECT_GE(worst["x1"].GetInt(), worst["x"].GetInt());
  EXPECT_GT(worst["line"].GetInt(), 0);
  EXPECT_GT(worst["share"].GetDouble(), 0.1);
}

TEST_F(DiffImages, ExplainComparesWithMine) {
  const rapidjson::Document document =
      parse_json(program({"diff", "--json", "right.png", "wrong.png", "--scene", "ball.xml"}).out);
  const std::string pixel = std::to_string(document["worst"]["x"].GetInt()) + "," +
                            std::to_string(document["worst"]["y"].GetInt());
  const std::vector<std::string> words{"explain", "ball.xml",  "--pixel",
                                       pixel,     "--profile", "course"};
  const auto with = [&](std::vector<std::string> more) {
    std::vector<std::string> all = words;
    all.insert(all.end(), more.begin(), more.end());
    return program(all);
  };
  EXPECT_THAT(with({"--mine", "wrong.png"}).out,
              HasSubstr("equals ours with the ambient term twice"));
  EXPECT_THAT(with({"--mine", "right.png"}).out, HasSubstr("of 255: equals ours"));
  const rapidjson::Document yours = parse_json(with({"--mine", "wrong.png", "--json"}).out);
  EXPECT_FALSE(yours["pixel"]["yours"]["equal"].GetBool());
  EXPECT_EQ(with({"--mine", "wrong.png", "--size", "32x24"}).status, 2);
  EXPECT_EQ(with({"--mine", "none.png"}).status, 3);
  EXPECT_EQ(program({"explain", "ball.xml", "--pixel", "64,0", "--mine", "right.png"}).status, 2);
}

TEST_F(DiffImages, AnswersInJson) {
  const ProgramRun run =
      program({"diff", "--json", "right.png", "wrong.png", "--scene", "ball.xml"});
  const rapidjson::Document document = parse_json(run.out);
  EXPECT_FALSE(document["same"].GetBool());
  EXPECT_LT(document["psnr_db"].GetDouble(), 60);
  EXPECT_STREQ(document["causes"][0]["cause"].GetString(), "ambient");
  EXPECT_GT(document["causes"][0]["explained"].GetDouble(), 0.9);
  EXPECT_EQ(document["a"]["width"].GetInt(), 64);
}

TEST_F(Grade, AClass) {
  for (const char* name : {"references", "class", "class/anna", "class/ben", "class/cleo"}) {
    std::filesystem::create_directory(folder.path(name));
  }
  folder.write("references/ball.png", folder.read("right.png"));
  folder.write("references/ball.xml", ball("0.2"));
  folder.write("class/anna/ball.png", folder.read("right.png"));
  folder.write("class/ben/ball.png", folder.read("wrong.png"));
  folder.write("class/cleo/ball.png", "no picture");
  std::filesystem::create_directory(folder.path("class/dan"));
  const ProgramRun run = program({"grade", "class", "--references", "references", "--report",
                                  "report.html", "--junit", "junit.xml"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(
      run.out,
      AllOf(HasSubstr("anna  1 of 1 passed\n"),
            HasSubstr("ben   0 of 1 passed\n    ball: differs: "),
            HasSubstr("cause: the ambient term is added twice"), HasSubstr("ball: unreadable: "),
            HasSubstr("dan   0 of 1 passed\n    missing: ball\n"),
            HasSubstr("4 students: 1 picture passed, 1 differs, 1 missing, 1 unreadable\n")));
  EXPECT_THAT(folder.read("report.html"), HasSubstr("data:image/png;base64,"));
  EXPECT_THAT(folder.read("junit.xml"), HasSubstr("<testsuites tests=\"4\" failures=\"3\">"));
  const rapidjson::Document document =
      parse_json(program({"grade", "--json", "class", "--references", "references"}).out);
  EXPECT_STREQ(document["students"][1]["pictures"][0]["causes"][0]["cause"].GetString(), "ambient");
}

TEST_F(Grade, SymbolicLinksAreNotFollowed) {
  for (const char* name : {"references", "class", "class/eve"}) {
    std::filesystem::create_directory(folder.path(name));
  }
  folder.write("references/ball.png", folder.read("right.png"));
  std::filesystem::create_symlink("../../references/ball.png", folder.path("class/eve/ball.png"));
  const ProgramRun run = program({"grade", "class", "--references", "references"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.out, HasSubstr("ball: unreadable: a symbolic link was submitted"));
}

TEST_F(Grade, AReferenceThatIsALinkToNothingIsAnError) {
  make_folders({"references", "class/eve"});
  folder.write("references/ball.png", folder.read("right.png"));
  std::filesystem::create_symlink("nothing", folder.path("references/cube.png"));
  const ProgramRun run = program({"grade", "class", "--references", "references"});
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("references/cube.png: cannot open: No such file"));
}

TEST_F(Grade, SubmissionsAreNoReferences) {
  make_folders({"all/right", "all/class/ada"});
  folder.write("all/right/ball.png", folder.read("right.png"));
  folder.write("all/class/ada/ball.png", folder.read("right.png"));
  std::filesystem::create_symlink("all", folder.path("link"));
  for (const char* references : {"all", "link", "all/class", "all/right/../class/"}) {
    const ProgramRun run = program({"grade", "all/class", "--references", references});
    EXPECT_EQ(run.status, 2) << references;
    EXPECT_THAT(run.err, AllOf(HasSubstr("class/ada/ball.png\" was handed in, but would be a "
                                         "reference, because it is in"),
                               HasSubstr(references)));
  }
  EXPECT_EQ(program({"grade", "all/class", "--references", "all/right"}).status, 0);
  // A folder with all of it.
  EXPECT_NE(program({"grade", "all", "--references", "all/right"}).status, 2);
}

TEST_F(Grade, AReferenceThatIsNoPictureIsAnError) {
  make_folders({"right", "class/ada"});
  folder.write("right/ball.png", "no picture");
  folder.write("class/ada/ball.png", folder.read("right.png"));
  const ProgramRun run = program({"grade", "class", "--references", "right"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err,
              AllOf(HasSubstr("right/ball.png: not a picture that scenefile reads"),
                    EndsWith("; it was taken as a reference, because it is in \"right\"\n")));
}

TEST_F(Grade, MistakesThatGiveTheSamePictureAreListed) {
  make_folders({"references", "class/eve"});
  folder.write("references/ball.png", folder.read("right.png"));
  folder.write("references/ball.xml", folder.read("ball.xml"));
  folder.write("class/eve/ball.png", folder.read("wrong.png"));
  const Words grade{"grade", "class", "--references", "references"};
  // The second time, the result is read from the store.
  for (const Words& more : {Words{"--pages", "a"},
                            {"--store", "kept", "--pages", "b"},
                            {"--store", "kept", "--pages", "c"}}) {
    EXPECT_EQ(program(grade + more).status, 1);
    EXPECT_THAT(folder.read(more.back() + "/eve.html"),
                HasSubstr("<b>The ambient term is added twice</b> <code>ambient</code><br>or the "
                          "ambient term is missing the global coefficient<br>"));
  }
}

TEST_F(Grade, OneStudentWhoPasses) {
  for (const char* name : {"references", "mine"}) {
    std::filesystem::create_directory(folder.path(name));
    folder.write(std::string(name) + "/ball.png", folder.read("right.png"));
  }
  const ProgramRun run = program({"grade", "mine", "--references", "references"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.out, HasSubstr("mine  1 of 1 passed\n"));
  const ProgramRun lost =
      program({"grade", "mine", "--references", "references", "--csv", "references/ball.png"});
  EXPECT_EQ(lost.status, 2);
  EXPECT_THAT(lost.err, HasSubstr("would replace the reference references/ball.png"));
  const ProgramRun alike =
      program({"grade", "mine", "--references", "references", "--csv", "a", "--junit", "./a"});
  EXPECT_EQ(alike.status, 2);
  EXPECT_THAT(alike.err, HasSubstr("the JUnit file ./a would replace the CSV table a"));
}

TEST_F(Grade, CommonFoldersAndNames) {
  make_folders({"right/LIGHT", "right/INTERSECT", "mine/illuminate/required",
                "mine/intersect/required", "mine/__MACOSX/illuminate"});
  folder.write("right/LIGHT/ball.png", folder.read("right.png"));
  folder.write("right/INTERSECT/ball.png", folder.read("wrong.png"));
  folder.write("mine/illuminate/required/ball_gen.png", folder.read("right.png"));
  folder.write("mine/intersect/required/ball.png", folder.read("wrong.png"));
  folder.write("mine/__MACOSX/illuminate/ball.png", "no picture");
  const ProgramRun run = program({"grade", "mine/", "--references", "right"});
  EXPECT_EQ(run.status, 0) << run.out << run.err;
  EXPECT_THAT(run.out, HasSubstr("mine  2 of 2 passed\n"));
}

TEST_F(Grade, MapsAndAllReports) {
  make_folders({"right", "mine/results"});
  folder.write("right/ball.png", folder.read("right.png"));
  folder.write("mine/results/my picture.png", folder.read("right.png"));
  folder.write("names.csv", "# handed in, reference\n\nresults/my picture.png, ball\n");
  const ProgramRun run =
      program({"grade", "mine", "--references", "right", "--map", "names.csv", "--csv", "a.csv",
               "--gradescope", "results.json", "--pages", "pages"});
  EXPECT_EQ(run.status, 0) << run.out << run.err;
  EXPECT_THAT(folder.read("a.csv"), HasSubstr("\"mine\",\"ball\",passed,64x48,64x48,99.00"));
  EXPECT_THAT(folder.read("pages/mine.html"),
              AllOf(HasSubstr("<bdi>mine</bdi>"), HasSubstr("<b>1 of 1 picture</b> passed")));
  const rapidjson::Document results = parse_json(folder.read("results.json"));
  EXPECT_EQ(results["score"].GetInt(), 1);
  EXPECT_STREQ(results["tests"][0]["status"].GetString(), "passed");
  folder.write("names.csv", "ball\n");
  const ProgramRun bad = program({"grade", "mine", "--references", "right", "--map", "names.csv"});
  EXPECT_EQ(bad.status, 1);
  EXPECT_THAT(bad.err, HasSubstr("line 1: expected the name handed in, a comma"));
  folder.write("names.csv", "Results/My Picture.png, ball\nother.png, ball\n");
  const ProgramRun unused =
      program({"grade", "mine", "--references", "right", "--map", "names.csv"});
  EXPECT_EQ(unused.status, 0) << unused.out << unused.err;
  EXPECT_EQ(unused.err,
            fmt::format("{}note: the map assigns \"other.png\" to a reference, but no student has "
                        "it\n",
                        no_scenes_note));
  folder.write("names.csv", "results/my picture.png, bal\n");
  const ProgramRun unknown =
      program({"grade", "mine", "--references", "right", "--map", "names.csv"});
  EXPECT_EQ(unknown.status, 1);
  EXPECT_THAT(unknown.err, HasSubstr("to the reference \"bal\", but \"right\" has no such file"));
}

TEST_F(Grade, NamesInMapsMayContainCommas) {
  make_folders({"right", "mine"});
  folder.write("right/ball.png", folder.read("right.png"));
  folder.write("mine/one, \"2\".png", folder.read("right.png"));
  for (const char* line : {"\"one, \"\"2\"\".png\", ball", "one, \"2\".png\tball"}) {
    folder.write("names.csv", line);
    const ProgramRun run =
        program({"grade", "mine", "--references", "right", "--map", "names.csv"});
    EXPECT_EQ(run.status, 0) << line << run.out << run.err;
  }
  folder.write("names.csv", "one, 2.png, ball");
  EXPECT_THAT(program({"grade", "mine", "--references", "right", "--map", "names.csv"}).err,
              HasSubstr("names that contain a comma in double quotes"));
}

TEST_F(Grade, EachStudentHasAPageOfTheirOwn) {
  std::filesystem::create_directories(folder.path("right"));
  folder.write("right/ball.png", folder.read("right.png"));
  for (const char* student : {"a b", "a_b", "a_b-2", "J\xC3\xB6rg"}) {
    std::filesystem::create_directories(folder.path("class/" + std::string(student)));
    folder.write("class/" + std::string(student) + "/ball.png", folder.read("right.png"));
  }
  const ProgramRun run =
      program({"grade", "class", "--references", "right", "--pages", "new/pages"});
  EXPECT_EQ(run.status, 0) << run.err;
  // The file's name depends on the student alone.
  EXPECT_THAT(folder.read("new/pages/a_b-3fe16d8a.html"),
              HasSubstr("<h2 class=\"who\"><bdi>a b</bdi>"));
  EXPECT_THAT(folder.read("new/pages/a_b.html"), HasSubstr("<h2 class=\"who\"><bdi>a_b</bdi>"));
  EXPECT_THAT(folder.read("new/pages/a_b-2.html"), HasSubstr("<h2 class=\"who\"><bdi>a_b-2</bdi>"));
  EXPECT_THAT(folder.read("new/pages/J\xC3\xB6rg.html"),
              HasSubstr("<h2 class=\"who\"><bdi>J\xC3\xB6rg</bdi>"));
}

TEST_F(Grade, NothingRemainsOfAnInterruptedRun) {
  std::filesystem::create_directories(folder.path("right"));
  folder.write("right/ball.png", folder.read("right.png"));
  folder.write("right/ball.xml", folder.read("ball.xml"));
  for (int i = 0; i < 400; ++i) {
    const std::string student = "class/s" + std::to_string(i);
    std::filesystem::create_directories(folder.path(student));
    folder.write(student + "/ball.png", folder.read("wrong.png"));
  }
  const auto entries = [&] {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
      names.insert(entry.path().filename().string());
    }
    return names;
  };
  const std::set<std::string> before = entries();
  const ProgramRun run = run_program({"grade", "class", "--references", "right", "--report",
                                      "report.html", "--pages", "pages", "--csv", "a.csv"},
                                     {.folder = folder.path(), .signal = SIGINT, .delay_ms = 500});
  EXPECT_EQ(run.status, 130) << run.err;
  EXPECT_EQ(entries(), before);
}

TEST_F(Grade, NothingRemainsIfAFileCannotBeWritten) {
  for (const char* name : {"right", "mine"}) {
    std::filesystem::create_directories(folder.path(name));
    folder.write(std::string(name) + "/ball.png", folder.read("right.png"));
  }
  const ProgramRun run = program({"grade", "mine", "--references", "right", "--pages", "new/pages",
                                  "--csv", "new/pages/mine.html/a.csv"});
  EXPECT_EQ(run.status, 3) << run.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path("new")));
}

TEST_F(Grade, TheReportHasATitleAndADate) {
  make_folders({"right", "class/anna"});
  folder.write("right/ball.png", folder.read("right.png"));
  folder.write("class/anna/ball.png", folder.read("right.png"));
  const Words words{"grade", "class/", "--references", "right"};
  const auto report = [&](const Words& more) {
    EXPECT_EQ(run_program(words + Words{"--report", "r.html", "--pages", "pages"} + more,
                          {.environment = {"SOURCE_DATE_EPOCH=86400"}, .folder = folder.path()})
                  .err,
              no_scenes_note);
    return folder.read("r.html") + folder.read("pages/anna.html");
  };
  const std::string first = report({});
  EXPECT_THAT(first, AllOf(HasSubstr("<title>class</title>"), HasSubstr("Graded on 1970-01-02")));
  EXPECT_EQ(report({}), first);
  EXPECT_THAT(report({"--title", "A <b>"}),
              AllOf(HasSubstr("<title>A &lt;b&gt;</title>"), Not(HasSubstr("<title>class"))));
  EXPECT_EQ(program(words + Words{"--title", "A"}).status, 2);
}

TEST_F(Grade, PicturesNextToFoldersAreOfOneStudent) {
  make_folders({"right", "mine/old"});
  folder.write("right/ball.png", folder.read("right.png"));
  folder.write("mine/ball.png", folder.read("right.png"));
  folder.write("mine/old/notes.png", folder.read("wrong.png"));
  EXPECT_THAT(program({"grade", "mine", "--references", "right"}).out,
              HasSubstr("mine  1 of 1 passed"));
}

TEST_F(Grade, TexturesOfScenesAreNotReferences) {
  make_folders({"right/textures", "mine"});
  folder.write("right/ball.png", folder.read("right.png"));
  folder.write("right/ball.xml", folder.read("ball.xml"));
  folder.write("right/textures/wood.png", folder.read("wrong.png"));
  folder.write("mine/ball.png", folder.read("right.png"));
  EXPECT_THAT(program({"grade", "mine", "--references", "right"}).out,
              HasSubstr("mine  1 of 1 passed"));
}

TEST_F(Grade, ScenesThatNameNoMistakesAreSaid) {
  make_folders({"right", "mine", "scenes"});
  folder.write("right/ball.png", folder.read("right.png"));
  folder.write("mine/ball.png", folder.read("wrong.png"));
  folder.write("scenes/box.xml", ball("0.2"));
  const Words words{"grade", "mine", "--references", "right", "--scenes", "scenes"};
  EXPECT_EQ(program(words).err,
            "note: no scene has the name of ball: most mistakes in its pictures cannot be named\n");
  std::string other = ball("0.2");
  other.replace(other.find("v=\"40\""), 6, "v=\"12\"");
  folder.write("scenes/ball.xml", other);
  const ProgramRun run = program(words);
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("of the pixels, so most mistakes cannot be named\n"));
}

TEST_F(Grade, ReferencesWithoutScenesAreSaidOnce) {
  make_folders({"right", "mine"});
  for (const char* name : {"ball", "cube"}) {
    folder.write(fmt::format("right/{}.png", name), folder.read("right.png"));
    folder.write(fmt::format("mine/{}.png", name), folder.read("right.png"));
  }
  const Words words{"grade", "mine", "--references", "right"};
  EXPECT_EQ(program(words).err, no_scenes_note);
  folder.write("right/ball.xml", folder.read("ball.xml"));
  EXPECT_EQ(program(words).err,
            "note: no scene has the name of cube: most mistakes in its pictures cannot be named\n");
}

TEST_F(Grade, WhatIsNoMistakeSaysSo) {
  make_folders({"right", "mine"});
  draw("ball.xml", "right/ball.png", "320x240");
  folder.write("right/ball.xml", folder.read("ball.xml"));
  folder.write("mine/ball.jpg", jpeg_of(*decode_image(folder.read("right/ball.png")), 75));
  program({"grade", "mine", "--references", "right", "--csv", "a.csv", "--gradescope", "r.json"});
  EXPECT_THAT(folder.read("a.csv"), HasSubstr("JPEGs; this is not a mistake by itself\"\r\n"));
  EXPECT_THAT(folder.read("r.json"), HasSubstr("Note: "));
}

// Whatever the folders of a repository are called.
TEST_F(Grade, GradescopeIsForOneStudent) {
  make_folders({"right", "mine/work", "mine/textures"});
  folder.write("right/ball.png", folder.read("right.png"));
  folder.write("mine/work/ball.png", folder.read("right.png"));
  folder.write("mine/textures/wood.png", folder.read("wrong.png"));
  const ProgramRun run =
      program({"grade", "mine", "--references", "right", "--gradescope", "results.json"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("mine  1 of 1 passed\n"));
  EXPECT_EQ(parse_json(folder.read("results.json"))["tests"].Size(), 1U);
}

TEST_F(Grade, AnotherSizeIsScaledAndReported) {
  make_folders({"right", "mine"});
  folder.write("right/ball.png", folder.read("right.png"));
  folder.write("mine/ball.png", folder.read("small.png"));
  const ProgramRun run = program({"grade", "mine", "--references", "right"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.out, HasSubstr("the size is 32x24, expected 64x48; compared after scaling"));
  const rapidjson::Document document =
      parse_json(program({"grade", "mine", "--references", "right", "--json"}).out);
  const rapidjson::Value& picture = document["students"][0]["pictures"][0];
  EXPECT_FALSE(picture["same_size"].GetBool());
  EXPECT_EQ(picture["size"]["width"].GetInt(), 32);
  EXPECT_EQ(picture["expected_size"]["height"].GetInt(), 48);
}

TEST_F(Grade, PicturesThatMatchNothingAreListed) {
  make_folders({"right", "mine/results"});
  folder.write("right/ball.png", folder.read("right.png"));
  folder.write("right/cube.png", folder.read("wrong.png"));
  folder.write("mine/ball (1).png", folder.read("right.png"));
  folder.write("mine/results/the box.png", folder.read("wrong.png"));
  const std::vector<std::string> words{"grade", "mine", "--references", "right"};
  EXPECT_THAT(
      program(words).out,
      AllOf(HasSubstr("mine  1 of 2 passed\n    ball: note: this file is the reference, byte for "
                      "byte\n    missing: cube\n"),
            HasSubstr("    1 picture matches no reference: results/the box.png; --map")));
  std::vector<std::string> more = words;
  more.insert(more.end(), {"--json", "--report", "report.html"});
  const rapidjson::Document document = parse_json(program(more).out);
  EXPECT_STREQ(document["students"][0]["unmatched"][0].GetString(), "results/the box.png");
  EXPECT_THAT(folder.read("report.html"),
              HasSubstr("1 picture matches no reference: results/the box.png."));
  // More than was asked for.
  folder.write("mine/cube.png", folder.read("wrong.png"));
  EXPECT_THAT(program(words).out, Not(HasSubstr("matches no reference")));
}

#ifdef SCENEFILE_ARCHIVE
TEST_F(Grade, ThePathsOfAFolderAndItsArchiveDiffer) {
  make_folders({"right", "class/ada", "class/ben"});
  folder.write("right/ball.png", folder.read("right.png"));
  folder.write("class/ada/ball.png", folder.read("right.png"));
  folder.write("class/ada.zip", write_archive("a.zip", {{"ball.png", folder.read("wrong.png")}}));
  const ProgramRun run = program({"grade", "class", "--references", "right", "--json"});
  EXPECT_THAT(run.out, HasSubstr("two pictures match: ada/ball.png was graded, "
                                 "ada.zip/ball.png was not"));
}

TEST_F(Grade, ArchivesAreFoldersAndNobodyIsLost) {
  make_folders({"right", "class/ada"});
  folder.write("right/test_ball.png", folder.read("right.png"));
  const std::string right = folder.read("right.png");
  const std::string wrong = folder.read("wrong.png");
  folder.write("class/ada/ball.png", right);
  folder.write("class/ada/ball_gen.png", wrong);
  folder.write("class/gina.zip", write_archive("a.zip", {{"images/ball.png", wrong}}));
  folder.write("class/hal.tgz",
               write_archive("a.tgz", {{"b.zip", write_archive("b.zip", {{"ball.png", right}})}}));
  folder.write("class/ida.zip", write_archive("a.zip", {{"ball.png", right}}, "secret"));
  folder.write("class/jon.zip", "damaged");
  folder.write("class/smithjohn_LATE_12_345_ball.png", right);
  folder.write("class/stray.png", right);
  const std::vector<std::string> words{"grade", "class", "--references", "right"};
  const ProgramRun run = program(words);
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, no_scenes_note);
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("ada        1 of 1 passed\n"),
                    HasSubstr("gina       0 of 1 passed\n    test_ball: differs: "),
                    HasSubstr("hal        1 of 1 passed\n"),
                    HasSubstr("ida        0 of 1 passed\n    missing: test_ball\n"),
                    HasSubstr("smithjohn  1 of 1 passed\n"),
                    HasSubstr("identical files:\n    test_ball: ada, hal, smithjohn\n"),
                    HasSubstr("    stray.png: its name does not say whose picture it is\n"),
                    HasSubstr("    ida.zip/ball.png: protected by a password\n"),
                    HasSubstr("    jon.zip: it cannot be read as an archive: "),
                    HasSubstr("    ada/ball_gen.png: ball.png is used for test_ball\n")));
  std::vector<std::string> more = words;
  more.insert(more.end(), {"--json", "--csv-students", "s.csv"});
  const rapidjson::Document document = parse_json(program(more).out);
  EXPECT_EQ(document["ignored"].Size(), 4U);
  EXPECT_STREQ(document["ignored"][0]["path"].GetString(), "stray.png");
  EXPECT_FALSE(document["ignored"][0].HasMember("student"));
  EXPECT_STREQ(document["ignored"][1]["student"].GetString(), "ada");
  const rapidjson::Value& notes = document["students"][0]["pictures"][0]["notes"];
  ASSERT_EQ(notes.Size(), 3U);
  EXPECT_STREQ(notes[0].GetString(), "this file is the reference, byte for byte");
  EXPECT_STREQ(notes[1].GetString(),
               "two pictures match: ball.png was graded, ball_gen.png was not");
  EXPECT_STREQ(notes[2].GetString(), "identical files: ada, hal, smithjohn");
  const rapidjson::Value& smithjohn = document["students"][document["students"].Size() - 1];
  EXPECT_STREQ(smithjohn["pictures"][0]["notes"][1].GetString(),
               "handed in late, as the name of the file says");
  EXPECT_THAT(folder.read("s.csv"), HasSubstr("\"ida\",0,1,0,1,0,1\r\n"));
  // A store gives the same answer.
  std::vector<std::string> with_store = words;
  with_store.insert(with_store.end(), {"--store", "graded"});
  for (const char* part : {"1/3", "2/3", "3/3"}) {
    std::vector<std::string> share = with_store;
    share.insert(share.end(), {"--part", part});
    EXPECT_EQ(program(share).status, 0);
  }
  EXPECT_EQ(program(with_store).out, run.out);
  // An archive is an input.
  more.back() = "class/gina.zip";
  EXPECT_EQ(program(more).status, 2);
}
#endif

// Viewers show nothing of it, but its colors are right.
TEST_F(Grade, ATransparentPictureIsNoted) {
  make_folders({"right", "mine"});
  Image white(2, 2);
  std::fill(white.rgb.begin(), white.rgb.end(), 1.0f);
  folder.write("right/ball.png", *encode_image(white, ImageFormat::png8, Rounding::nearest));
  // The same with alpha 0.
  folder.write("mine/ball.png",
               *base64_decoded("iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAEUlEQVR42mP4"
                               "//8/AwgzwBgAcaAL9XaJ+KkAAAAASUVORK5CYII="));
  const std::string note =
      "all its pixels are transparent (alpha 0): viewers show nothing, but alpha is not compared";
  const ProgramRun run = program({"grade", "mine", "--references", "right", "--csv", "a.csv"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(folder.read("a.csv"), HasSubstr(note));
  const ProgramRun diff = program({"diff", "right/ball.png", "mine/ball.png"});
  EXPECT_EQ(diff.status, 0);
  EXPECT_THAT(diff.out, AllOf(HasSubstr("  mine/ball.png: " + note + "\n"), HasSubstr("\nequal\n"),
                              Not(HasSubstr("right/ball.png: all"))));
}

TEST_F(Grade, AJpegIsReported) {
  make_folders({"right", "mine"});
  folder.write("right/ball.png", folder.read("right.png"));
  std::filesystem::copy_file(std::filesystem::path(SCENEFILE_FIXTURES) / "asset/rgb.jpg",
                             folder.path("mine/ball.png"));
  EXPECT_THAT(program({"grade", "mine", "--references", "right"}).out,
              HasSubstr("; it is a JPEG, which changes colors: a PNG is needed"));
  const ProgramRun run = program({"diff", "right.png", "mine/ball.png"});
  EXPECT_THAT(run.out,
              HasSubstr("  mine/ball.png is a JPEG, which changes colors: compare PNGs\n"));
  EXPECT_THAT(program({"diff", "right.png", "small.png"}).out, Not(HasSubstr("JPEG")));
}

TEST_F(Grade, ThePictureOfAnotherReferenceIsReported) {
  make_folders({"right", "mine"});
  std::string box = ball("0.2");
  box.replace(box.find("\"sphere\""), 8, "\"cube\"");
  folder.write("box.xml", box);
  draw("box.xml", "box.png", "64x48");
  folder.write("right/ball.png", folder.read("right.png"));
  folder.write("right/box.png", folder.read("box.png"));
  folder.write("mine/ball.png", folder.read("box.png"));
  folder.write("mine/box.png", folder.read("right.png"));
  const ProgramRun run = program({"grade", "mine", "--references", "right"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.out, AllOf(HasSubstr("ball: differs: it is the picture of box\n"),
                             HasSubstr("box: differs: it is the picture of ball\n")));
}

// A black picture is close to a dark reference, but not the picture of it.
TEST_F(Grade, ABlackPictureIsNotThatOfADarkReference) {
  make_folders({"right", "mine"});
  const auto gray = [](const char* value) {
    return scene_with(
        fmt::format(R"(<ambient r="{0}" g="{0}" b="{0}"/> <diffuse r="0" g="0" b="0"/>)", value));
  };
  folder.write("dark.xml", gray("0.02"));
  folder.write("black.xml", gray("0"));
  draw("dark.xml", "right/dark.png", "64x48");
  draw("black.xml", "mine/ball.png", "64x48");
  folder.write("right/ball.png", folder.read("right.png"));
  folder.write("mine/dark.png", folder.read("right/dark.png"));
  const ProgramRun run = program({"grade", "mine", "--references", "right"});
  EXPECT_THAT(run.out, AllOf(HasSubstr("ball: differs: "), Not(HasSubstr("it is the picture of"))));
}

TEST_F(Grade, NoMatchIsAnErrorNotAGradeOfZero) {
  make_folders({"right", "class/anna"});
  folder.write("right/ball.png", folder.read("right.png"));
  folder.write("class/anna/cube.png", folder.read("right.png"));
  const ProgramRun run = program({"grade", "class", "--references", "right"});
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err,
              AllOf(HasSubstr("no picture in \"class\" has the name of a reference in \"right\": "
                              "looked for ball.png, "),
                    HasSubstr("found \"cube.png\", for example")));
  make_folders({"class2/anna"});
  EXPECT_THAT(program({"grade", "class2", "--references", "right"}).err,
              HasSubstr("\"class2\" contains no pictures\n"));
}

TEST_F(Grade, MissingArguments) {
  EXPECT_EQ(program({"grade", "."}).status, 2);
  EXPECT_EQ(program({"grade", "nowhere", "--references", "."}).status, 3);
  std::filesystem::create_directory(folder.path("empty"));
  const ProgramRun run = program({"grade", ".", "--references", "empty"});
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("\"empty\" contains no pictures"));
  const ProgramRun no_scenes = program({"grade", ".", "--references", ".", "--scenes", "nowhere"});
  EXPECT_EQ(no_scenes.status, 3);
  EXPECT_THAT(no_scenes.err, HasSubstr("\"nowhere\" is not a readable folder"));
  EXPECT_EQ(no_scenes.out, "");
}

}  // namespace

}  // namespace scenefile
