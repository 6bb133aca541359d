// The command frames: pictures from a moving camera.

#include "app/run_program.h"
#include "scenefile/asset/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace scenefile {
namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

using Words = std::vector<std::string>;

constexpr const char* path_of_views = R"({"fps": 2, "views": [
  {"time": 0, "position": [0, 1, 5], "focus": [0, 0, 0], "up": [0, 1, 0]},
  {"time": 1, "position": [4, 1, 3], "heightAngle": 30},
  {"time": 2.5, "position": [4, 2, -3], "look": [-4, -2, 3]}]})";

// Whether a frame has the pixels of a picture; it also contains its key.
bool shows(const std::string& frame, const std::string& picture) {
  const Result<Texture> a = decode_image(frame);
  const Result<Texture> b = decode_image(picture);
  return a && b && a->width == b->width && a->rgb == b->rgb;
}

struct FramesTest : ProgramFolder {
  FramesTest() {
    folder.write("scene.xml", good_scene);
    folder.write("views.json", path_of_views);
  }

  ProgramRun frames(Words more) const {
    more.insert(more.begin(), {"frames", "scene.xml", "--size", "32x24"});
    return program(more);
  }
  std::string render(const std::string& scene) const {
    EXPECT_EQ(program({"render", scene, "-o", "one.png", "--size", "32x24"}).status, 0);
    return folder.read("one.png");
  }
};

TEST_F(FramesTest, AreRendersOfTheirScenes) {
  struct Case {
    Words motion;
    std::string frame;
    std::string scenes;
    int count;
  };
  for (const auto& [motion, name, scenes, count] :
       {Case{{"--turntable", "5"}, "f", "s%02d.xml", 5},
        Case{{"--path", "views.json"}, "g", "s%02d.json", 6}}) {
    Words words{"-o", name + "%02d.png", "--write-scenes", scenes};
    words.insert(words.end(), motion.begin(), motion.end());
    const ProgramRun drawn = frames(words);
    ASSERT_EQ(drawn.status, 0) << drawn.err;
    std::string before;
    for (int number = 1; number <= count; ++number) {
      const std::string digits = std::string("0").append(std::to_string(number));
      const std::string frame = folder.read(name + digits + ".png");
      EXPECT_TRUE(shows(frame, render("s" + digits + scenes.substr(5)))) << digits;
      EXPECT_FALSE(frame == before);
      before = frame;
    }
    EXPECT_FALSE(std::filesystem::exists(
        folder.path(name + std::string("0").append(std::to_string(count + 1)) + ".png")));
  }
}

TEST_F(FramesTest, TheFirstOfATurnIsTheCameraOfTheFile) {
  ASSERT_EQ(frames({"--turntable", "3", "-o", "f%d.png", "--range", "1:1"}).status, 0);
  EXPECT_TRUE(shows(folder.read("f1.png"), render("scene.xml")));
  EXPECT_FALSE(std::filesystem::exists(folder.path("f2.png")));
}

TEST_F(FramesTest, ExistingFramesAreSkipped) {
  const Words words{"--turntable", "3", "-o", "f%d.png", "--json"};
  const auto counts = [&] {
    const rapidjson::Document answer = parse_json(frames(words).out);
    return std::pair(answer["drawn"].GetInt(), answer["skipped"].GetInt());
  };
  EXPECT_EQ(counts(), std::pair(3, 0));
  const std::string second = folder.read("f2.png");
  EXPECT_EQ(counts(), std::pair(0, 3));
  folder.write("f2.png", second.substr(0, 90));  // damaged
  std::filesystem::remove(folder.path("f3.png"));
  EXPECT_EQ(counts(), std::pair(2, 1));
  EXPECT_TRUE(folder.read("f2.png") == second);
  std::string changed = second;
  changed[second.size() / 2] ^= 1;
  folder.write("f2.png", changed);
  EXPECT_EQ(counts(), std::pair(1, 2));
  EXPECT_TRUE(folder.read("f2.png") == second);
  folder.write("f2.png", "");
  EXPECT_EQ(counts(), std::pair(1, 2));
  EXPECT_TRUE(folder.read("f2.png") == second);
  EXPECT_THAT(folder.list(), ElementsAre("f1.png", "f2.png", "f3.png", "scene.xml", "views.json"));
}

// Each file of a frame says what it was drawn from, in every format.
TEST_F(FramesTest, FilesContainTheirKey) {
  for (const Words& words : {Words{"-o", "f%d.png", "--aov", "depth"},
                             Words{"-o", "f%d.exr", "--aov", "depth"}, Words{"-o", "f%d.pfm"}}) {
    const Words all = Words{"--turntable", "2", "--json"} + words;
    EXPECT_EQ(parse_json(frames(all).out)["drawn"].GetInt(), 2);
    const std::string end = words[1].substr(3);
    EXPECT_THAT(folder.read("f2" + end), HasSubstr("scenefile item 1: program="));
    EXPECT_THAT(folder.read("f2" + end), HasSubstr(" width=32 height=24 "));
    EXPECT_EQ(parse_json(frames(all).out)["skipped"].GetInt(), 2);
    EXPECT_EQ(program({"diff", "f1" + end, "f1" + end}).status, 0);
    if (end == ".png") {
      std::string valid = folder.read("f2.png");
      renew_png_text(valid);
      EXPECT_TRUE(valid == folder.read("f2.png")) << "other programs check the CRC";
      std::filesystem::remove(folder.path("f2.depth.png"));
      EXPECT_EQ(parse_json(frames(all).out)["drawn"].GetInt(), 1);
      EXPECT_TRUE(std::filesystem::exists(folder.path("f2.depth.png")));
    }
  }
}

TEST_F(FramesTest, NoOtherPictureIsReplaced) {
  const Words words{"--turntable", "3", "-o", "f%d.png"};
  ASSERT_EQ(frames(words).status, 0);
  std::filesystem::remove(folder.path("f1.png"));
  const std::string second = folder.read("f2.png");
  const auto refused = [&](const Words& more, const std::string& why) {
    Words all = words;
    all.insert(all.end(), more.begin(), more.end());
    const ProgramRun run = frames(all);
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.err, HasSubstr(why));
    EXPECT_TRUE(folder.read("f2.png") == second);
    EXPECT_FALSE(std::filesystem::exists(folder.path("f1.png"))) << "drawn before the refusal";
  };
  refused({"--samples", "3"},
          "f2.png: the frame was drawn with samples = 16, not 3; --overwrite replaces it, or");
  const Words four{"--turntable", "4", "-o", "f%d.png"};
  EXPECT_THAT(frames(four).err, HasSubstr("f2.png: the frame was drawn with another camera"));
  folder.write("scene.xml", std::string(good_scene) + "\n");
  refused({}, "f2.png: the frame was drawn from another scene, or the scene was changed; ");
  refused({"--samples", "3"}, "the scene was changed, and with samples = 16, not 3; --overwrite");
  folder.write("f2.png", "my picture");
  EXPECT_THAT(
      frames(words).err,
      HasSubstr("f2.png: the file exists, and is not a frame; --overwrite replaces it, or choose"));
  EXPECT_EQ(frames({"--turntable", "3", "-o", "f%d.png", "--range", "1:1"}).status, 0);
  folder.write("mine1.png", "mine");
  const ProgramRun mine = frames({"--turntable", "3", "-o", "mine%d.png"});
  EXPECT_EQ(mine.status, 1);
  EXPECT_THAT(mine.err, HasSubstr("mine1.png: the file exists, and is not a frame"));
  EXPECT_EQ(folder.read("mine1.png"), "mine");
}

TEST_F(FramesTest, AFrameThatSomebodyEditedIsKept) {
  const Words words{"--turntable", "2", "-o", "f%d.pfm"};
  ASSERT_EQ(frames(words).status, 0);
  std::string edited = folder.read("f1.pfm");
  edited[edited.size() / 2] ^= 1;
  folder.write("f1.pfm", edited);
  const ProgramRun refused = frames(words);
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("f1.pfm: the frame was changed after it was drawn; "));
  EXPECT_EQ(folder.read("f1.pfm"), edited);
  EXPECT_EQ(frames(words + Words{"--overwrite"}).status, 0);
}

TEST_F(FramesTest, OverwriteReplacesWhatIsNotOfThisMotion) {
  const auto counts = [&](const Words& more) {
    const rapidjson::Document answer =
        parse_json(frames(Words{"--turntable", "3", "-o", "f%d.png", "--json"} + more).out);
    return std::pair(answer["drawn"].GetInt(), answer["skipped"].GetInt());
  };
  EXPECT_EQ(counts({}), std::pair(3, 0));
  const std::string before = folder.read("f2.png");
  folder.write("f3.png", "mine");
  EXPECT_EQ(counts({"--overwrite"}), std::pair(1, 2)) << "frames of this motion are kept";
  EXPECT_EQ(counts({"--overwrite", "--mode", "normals"}), std::pair(3, 0));
  EXPECT_FALSE(folder.read("f2.png") == before);
  EXPECT_EQ(counts({"--overwrite"}), std::pair(3, 0));
  EXPECT_TRUE(folder.read("f2.png") == before);
}

TEST_F(FramesTest, NoOtherSceneIsReplaced) {
  const Words words{"--turntable", "3", "--write-scenes", "t%d.xml"};
  ASSERT_EQ(frames(words).status, 0);
  const std::string second = folder.read("t2.xml");
  EXPECT_EQ(frames(words).status, 0) << "the same scenes again";
  folder.write("t2.xml", "<!-- mine -->\n" + second);
  std::filesystem::remove(folder.path("t1.xml"));
  const ProgramRun refused = frames(words);
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("t2.xml: the file exists, and is not the scene of this frame; "
                                     "--overwrite replaces it, or choose another name after "
                                     "--write-scenes"));
  EXPECT_EQ(folder.read("t2.xml"), "<!-- mine -->\n" + second);
  EXPECT_FALSE(std::filesystem::exists(folder.path("t1.xml"))) << "written before the refusal";
  EXPECT_EQ(frames(words + Words{"--overwrite"}).status, 0);
  EXPECT_EQ(folder.read("t2.xml"), second);
  std::filesystem::copy_file(folder.path("scene.xml"), folder.path("own1.xml"));
  const ProgramRun own = program(
      {"frames", "own1.xml", "--turntable", "3", "--write-scenes", "own%d.xml", "--overwrite"});
  EXPECT_EQ(own.status, 2);
  EXPECT_THAT(own.err, HasSubstr("the scene of a frame own1.xml would replace the scene own1.xml"));
  EXPECT_EQ(folder.read("own1.xml"), good_scene);
}

TEST_F(FramesTest, TheCaseOfAnExtensionDoesNotMatter) {
  ASSERT_EQ(frames({"--turntable", "1", "--write-scenes", "t%d.JSON"}).status, 0);
  EXPECT_EQ(folder.read("t1.JSON").front(), '{');
}

TEST_F(FramesTest, ScenesInAnotherFolderSayWhichFilesAreMissingThere) {
  std::filesystem::create_directories(folder.path("far/away"));
  folder.write("textured.xml",
               scene_with("<diffuse r=\"1\" g=\"0\" b=\"0\"/><texture file=\"one.png\" u=\"1\" "
                          "v=\"1\"/>"));
  render("scene.xml");
  const ProgramRun out =
      program({"frames", "textured.xml", "--turntable", "2", "--write-scenes", "far/away/s%d.xml"});
  EXPECT_EQ(out.status, 0) << out.err;
  EXPECT_THAT(out.err, AllOf(HasSubstr("\"one.png\" is not found from the folder of the output"),
                             HasSubstr("far/away/s%d.xml: 2 scenes written")));
}

TEST_F(FramesTest, OpenGlDrawsTheRendersOfTheirScenes) {
  const ProgramRun drawn =
      frames({"--turntable", "3", "-o", "f%d.png", "--write-scenes", "s%d.xml", "--engine", "gl"});
  if (drawn.status == 3) {
    GTEST_SKIP() << drawn.err;
  }
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  for (const std::string number : {"1", "2", "3"}) {
    ASSERT_EQ(program({"render", "s" + number + ".xml", "-o", "one.png", "--size", "32x24",
                       "--engine", "gl"})
                  .status,
              0);
    EXPECT_TRUE(shows(folder.read("f" + number + ".png"), folder.read("one.png"))) << number;
  }
  EXPECT_FALSE(folder.read("f1.png") == folder.read("f2.png"));
  EXPECT_THAT(frames({"--turntable", "3", "-o", "f%d.png"}).err,
              HasSubstr("with engine = gl, not trace"));
  const ProgramRun again =
      frames({"--turntable", "3", "-o", "f%d.png", "--engine", "gl", "--json"});
  EXPECT_EQ(parse_json(again.out)["skipped"].GetInt(), 3);
  EXPECT_EQ(frames({"--turntable", "3", "-o", "g%d.png", "--engine", "gl", "--denoise"}).status, 2);
  EXPECT_EQ(frames({"--turntable", "1", "-o", "r%d.png", "--profile", "realtime"}).status, 0);
  ASSERT_EQ(
      program({"render", "scene.xml", "-o", "one.png", "--size", "32x24", "--profile", "realtime"})
          .status,
      0);
  EXPECT_TRUE(shows(folder.read("r1.png"), folder.read("one.png")));
}

// A stand-in for ffmpeg: it writes its arguments to its output, the last of them.
TEST_F(FramesTest, AVideoNeedsAllFrames) {
  std::filesystem::create_directory(folder.path("bin"));
  folder.write("bin/ffmpeg", "#!/bin/sh\nfor out; do :; done\necho \"$@\" > \"$out\"\n");
  std::filesystem::permissions(folder.path("bin/ffmpeg"), std::filesystem::perms::owner_all);
  const auto video = [&](Words more) {
    more.insert(more.begin(), {"frames", "scene.xml", "--size", "32x24", "--turntable", "3"});
    return run_program(more, {.environment = {"PATH=" + folder.path("bin") + ":/usr/bin:/bin"},
                              .folder = folder.path()});
  };
  EXPECT_EQ(video({"-o", "v%d.png", "--video", "v.mp4", "--fps", "12"}).status, 0);
  EXPECT_THAT(folder.read("v.mp4"), AllOf(HasSubstr("-framerate 12 "), HasSubstr("-i ./v%d.png "),
                                          HasSubstr("-pix_fmt yuv420p -frames:v 3 ")));
  const Words first{"-o", "f%d.png", "--video", "f.gif", "--range", "1:1"};
  const ProgramRun part = video(first);
  EXPECT_EQ(part.status, 1);
  EXPECT_THAT(part.err, HasSubstr("frame 2 of 3 does not exist yet"));
  EXPECT_FALSE(std::filesystem::exists(folder.path("f.gif")));
  ASSERT_EQ(video({"-o", "f%d.png", "--range", "2:3"}).status, 0);
  EXPECT_EQ(video(first).status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.path("f.gif")));
  std::filesystem::create_symlink("f.gif", folder.path("link.GIF"));
  EXPECT_EQ(video({"-o", "v%d.png", "--video", "link.GIF"}).status, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link.GIF")));
  EXPECT_THAT(folder.read("f.gif"), AllOf(HasSubstr("-i ./v%d.png "), Not(HasSubstr("yuv420p"))));
}

TEST_F(FramesTest, AVideoDoesNotNeedToKeepItsFrames) {
  std::filesystem::create_directories(folder.path("bin"));
  std::filesystem::create_directories(folder.path("tmp"));
  folder.write("bin/ffmpeg",
               "#!/bin/sh\nfor out; do :; done\nls $TMPDIR/* > \"$out\"\nexit $STATUS\n");
  std::filesystem::permissions(folder.path("bin/ffmpeg"), std::filesystem::perms::owner_all);
  for (const std::string status : {"0", "1"}) {
    const ProgramRun made = run_program(
        {"frames", "scene.xml", "--size", "32x24", "--turntable", "3", "--video", "v.gif"},
        {.environment = {"PATH=" + folder.path("bin") + ":/usr/bin:/bin",
                         "TMPDIR=" + folder.path("tmp"), "STATUS=" + status},
         .folder = folder.path()});
    EXPECT_EQ(made.status, status == "0" ? 0 : 3) << made.err;
    EXPECT_THAT(folder.read("v.gif"), HasSubstr("1.png\n2.png\n3.png\n"));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path("tmp"))) << status;
    EXPECT_THAT(made.err,
                HasSubstr(status == "0" ? "v.gif: 3 of 3 frames drawn" : "ffmpeg failed"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path("1.png")));
  const Words words{"--turntable", "3", "--video", "w.gif"};
  EXPECT_EQ(frames(words + Words{"--range", "1:2"}).status, 2);
  EXPECT_EQ(frames(words + Words{"--aov", "depth"}).status, 2);
}

TEST_F(FramesTest, AVideoNeedsFfmpeg) {
  const ProgramRun none =
      run_program({"frames", "scene.xml", "--turntable", "3", "-o", "v%d.png", "--video", "v.mp4"},
                  {.environment = {"PATH=/nowhere"}, .folder = folder.path()});
  EXPECT_EQ(none.status, 3);
  EXPECT_THAT(none.err, HasSubstr("ffmpeg is not installed"));
}

TEST_F(FramesTest, UsageErrorsAreReportedImmediately) {
  EXPECT_EQ(frames({"-o", "f%d.png"}).status, 2);
  EXPECT_EQ(frames({"-o", "f%d.png", "--turntable", "3", "--path", "views.json"}).status, 2);
  EXPECT_EQ(frames({"--turntable", "3"}).status, 2);
  for (const char* const pattern : {"f.png", "f%s.png", "f%d%d.png", "f%4d.png", "f%d.jpg"}) {
    EXPECT_EQ(frames({"--turntable", "3", "-o", pattern}).status, 2) << pattern;
  }
  EXPECT_EQ(frames({"--turntable", "3", "-o", "f%d.png", "--range", "2:4"}).status, 2);
  EXPECT_EQ(frames({"--path", "none.json", "-o", "f%d.png"}).status, 3);
}

TEST_F(FramesTest, ErrorsInAPathHaveAPlace) {
  const auto complaint = [&](const std::string& text) {
    folder.write("views.json", text);
    const ProgramRun refused = frames({"--path", "views.json", "-o", "f%d.png"});
    EXPECT_EQ(refused.status, 1) << text;
    return refused.err;
  };
  EXPECT_THAT(complaint("{\"views\": [\n{\"places\": 1}]}"), HasSubstr("views.json:2:2: unknown"));
  EXPECT_THAT(complaint(R"({"views": [{"positon": [1, 2, 3]}]})"),
              HasSubstr("unknown key \"positon\"; did you mean \"position\"?"));
  EXPECT_THAT(complaint(R"({"views": [], "color": 1})"), HasSubstr("; known: fps, views"));
  EXPECT_THAT(complaint(R"({"views": [{"time": 2}, {"time": 2}]})"), HasSubstr("not after"));
  EXPECT_THAT(complaint(R"({"views": []})"), HasSubstr("no views"));
  EXPECT_THAT(complaint(R"({"views": [{"position": [1, 2]}]})"), HasSubstr("three numbers"));
  EXPECT_THAT(complaint("views"), HasSubstr("views.json:1:1"));
  EXPECT_THAT(complaint(R"({"views": [{"look": [0, 1, 0], "up": [0, 1, 0]}]})"),
              HasSubstr("views.json: view 1: up 0 1 0 of the camera is parallel"));
  EXPECT_THAT(complaint(R"({"views": [{"time": 0}, {"time": 1, "up": [0, 0, 0]}]})"),
              HasSubstr("view 2: up of the camera is 0 0 0"));
}

}  // namespace
}  // namespace scenefile
