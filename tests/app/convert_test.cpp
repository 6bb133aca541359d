#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string with_image =
    R"(<diffuse r="1" g="0.5" b="0"/><blend v="1"/><texture file="image/map.png" u="1" v="1"/>)";

struct Convert : ProgramFolder {
  // The files must exist, but are not opened.
  void make_folder(const std::string& name) {
    std::filesystem::create_directory(folder.path(name));
  }
};

TEST_F(Convert, RoundTripsKeepTheMeaning) {
  const std::string xml = folder.write("a.xml", good_scene);
  const std::string json = folder.path("a.json");
  const std::string back = folder.path("back.xml");
  const ProgramRun there = run_program({"convert", xml, json});
  EXPECT_EQ(there.status, 0);
  EXPECT_THAT(there.err, AllOf(HasSubstr("[write.light-id]"), HasSubstr(json + ": JSON, ")));
  EXPECT_THAT(there.err, Not(HasSubstr("warning")));
  EXPECT_EQ(run_program({"convert", json, back}).status, 0);
  for (const std::string& other : {json, back}) {
    const ProgramRun diff = run_program({"diff", xml, other});
    EXPECT_EQ(diff.status, 0) << diff.out;
    EXPECT_THAT(diff.out, HasSubstr(other == json ? "same meaning" : "no difference"));
  }
}

TEST_F(Convert, WritesForPovRay) {
  const std::string xml = folder.write("a.xml", good_scene);
  const std::string pov = folder.path("a.pov");
  const ProgramRun run = run_program({"convert", "--features", "shadows", xml, pov});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(folder.read("a.pov"), AllOf(HasSubstr("camera {"), HasSubstr("sphere {")));
  const ProgramRun features =
      run_program({"convert", "--features", "shadows", xml, folder.path("b.xml")});
  EXPECT_EQ(features.status, 2);
  EXPECT_THAT(features.err, HasSubstr("--features"));
}

// POV-Ray opens ASCII paths alone. Such a folder may be in every absolute path.
TEST_F(Convert, PovRayGetsPathsThatItOpens) {
  const std::string inner = folder.path("jos\u00e9");
  std::filesystem::create_directory(inner);
  const unsigned char tga[] = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 24, 0, 1, 2, 3};
  folder.write("jos\u00e9/a.tga", std::string(std::begin(tga), std::end(tga)));
  const std::string xml = folder.write(
      "jos\u00e9/a.xml", scene_with(R"(<blend v="1"/><texture file="a.tga" u="1" v="1"/>)"));
  const ProgramRun run = run_program({"convert", xml, inner + "/a.pov"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(folder.read("jos\u00e9/a.pov"), HasSubstr("tga \"a.tga\""));
  EXPECT_THAT(run.err, Not(HasSubstr("pov.lost")));
}

TEST_F(Convert, PovRayIsWrittenButNotRead) {
  const std::string pov = folder.path("a.pov");
  ASSERT_EQ(run_program({"convert", folder.write("a.xml", good_scene), pov}).status, 0);
  const ProgramRun back = run_program({"convert", pov, folder.path("b.xml")});
  EXPECT_EQ(back.status, 1);
  EXPECT_THAT(back.err, HasSubstr("a POV-Ray scene, which scenefile writes but does not read"));
}

TEST_F(Convert, HelpNamesTheModelsThatAreRead) {
  EXPECT_THAT(run_program({"help", "convert"}).out,
              AllOf(HasSubstr("glTF and OBJ"), HasSubstr("convert model.obj scene.xml")));
}

TEST_F(Convert, StandardStreamsNeedAFormat) {
  const ProgramRun json = run_program({"convert", "-", "-", "--to", "json"}, {.input = good_scene});
  EXPECT_EQ(json.status, 0);
  EXPECT_EQ(parse_json(json.out)["groups"].Size(), 2U);
  const ProgramRun none = run_program({"convert", "-", "-"}, {.input = good_scene});
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.err, HasSubstr("does not imply a format"));
}

// In JSON, each transform needs a separate nested group.
TEST_F(Convert, CostIsLinearInTheTransforms) {
  std::string moves;
  for (int i = 0; i < 50'000; ++i) {
    moves += "<translate x=\"1\" y=\"0\" z=\"0\"/>";
  }
  std::string scene = good_scene;
  scene.insert(scene.find("<transblock>") + 12, moves);
  const std::string xml = folder.write("a.xml", scene);
  const ProgramRun run =
      run_program({"convert", xml, folder.path("a.json"), "--max-memory", "500M"});
  EXPECT_EQ(run.status, 4);
  EXPECT_THAT(run.err, HasSubstr("nested deeper than the limit of 1024 levels"));
}

TEST_F(Convert, BrokenScenesWriteNothing) {
  const std::string bad = folder.write("bad.xml", scene_with(R"(<diffuse r="red" g="0" b="0"/>)"));
  const std::string out = folder.write("out.json", "as it was");
  const ProgramRun run = run_program({"convert", bad, out});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, AllOf(HasSubstr("[xml.number]"), Not(HasSubstr("out.json"))));
  EXPECT_EQ(folder.read("out.json"), "as it was");
}

TEST_F(Convert, TheSceneIsNotReplaced) {
  const std::string xml = folder.write("a.xml", good_scene);
  EXPECT_EQ(run_program({"convert", xml, xml}).status, 2);
  EXPECT_EQ(folder.read("a.xml"), good_scene);
  EXPECT_EQ(run_program({"convert", xml, folder.path("none/a.json")}).status, 3);
}

TEST_F(Convert, CompatCourseWritesEachObjectSeparately) {
  std::string twice = good_scene;
  const std::string end = "</object>\n    </transblock>";
  ASSERT_NE(twice.find(end), std::string::npos);
  twice.insert(twice.find(end) + 9, R"(<object type="primitive" name="cube"/>)");
  const std::string xml = folder.write("two.xml", twice);
  const std::string plain = run_program({"convert", xml, "-", "--to", "xml"}).out;
  const std::string course =
      run_program({"convert", "--compat", "course", xml, "-", "--to", "xml"}).out;
  EXPECT_THAT(plain, Not(HasSubstr("cube")));
  EXPECT_THAT(course, HasSubstr("cube"));
  EXPECT_EQ(run_program({"check", "-"}, {.input = course}).out, "<stdin>: fine\n");
}

TEST_F(Convert, FilesAreFoundFromTheOutputsFolder) {
  make_folder("in");
  make_folder("in/image");
  folder.write("in/image/map.png", "");
  const std::string xml = folder.write("in/a.xml", scene_with(with_image));
  const ProgramRun beside = run_program({"convert", xml, folder.path("in/b.xml")});
  EXPECT_THAT(beside.err, Not(HasSubstr("map.png")));
  const ProgramRun above = run_program({"convert", xml, folder.path("b.xml")});
  EXPECT_THAT(above.err, HasSubstr(R"("image/map.png" is written as "in/image/map.png")"));
  EXPECT_THAT(folder.read("b.xml"), HasSubstr(R"(file="in/image/map.png")"));
}

TEST_F(Convert, FilesLeftBehindAreReported) {
  make_folder("in");
  make_folder("in/image");
  make_folder("out");
  folder.write("in/image/map.png", "");
  const std::string xml = folder.write("in/a.xml", scene_with(with_image));
  const std::string out = folder.path("out/a.json");
  const ProgramRun lost = run_program({"convert", xml, out});
  EXPECT_EQ(lost.status, 0);
  EXPECT_THAT(lost.err, AllOf(HasSubstr("[convert.file-left-behind]"), HasSubstr("a.xml:15:")));
  EXPECT_THAT(folder.read("out/a.json"), HasSubstr(R"("image/map.png")"));
  const ProgramRun root = run_program({"convert", "--asset-root", folder.path("in"), xml, out});
  EXPECT_THAT(root.err, Not(HasSubstr("left-behind")));
}

TEST_F(Convert, FilesNextToTheOutputDoNotReplaceInputs) {
  const std::string triangle = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
  const std::string model = folder.write("scene-1.obj", triangle);
  const ProgramRun run = run_program({"convert", model, folder.path("scene.xml")});
  EXPECT_EQ(run.status, 2) << run.err;
  EXPECT_THAT(run.err, AllOf(HasSubstr("would replace"), HasSubstr("scene-1.obj")));
  EXPECT_EQ(folder.read("scene-1.obj"), triangle);
  EXPECT_FALSE(std::filesystem::exists(folder.path("scene.xml")));
  EXPECT_EQ(run_program({"convert", model, folder.path("other.xml")}).status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.path("other-1.obj")));
}

TEST_F(Convert, FilesNextToTheOutputDoNotReplaceTheModelsMaterials) {
  const std::string model =
      folder.write("model.obj", "mtllib scene-1.obj\nv -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("scene-1.obj", "newmtl red\nKd 1 0 0\n");
  const ProgramRun run = run_program({"convert", model, folder.path("scene.xml")});
  EXPECT_EQ(run.status, 2) << run.err;
  EXPECT_EQ(folder.read("scene-1.obj"), "newmtl red\nKd 1 0 0\n");
}

TEST_F(Convert, FilesNextToAnObjDoNotReplaceTheScenesMeshes) {
  const std::string mesh = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
  folder.write("out.mtl", mesh);  // a mesh, whatever its name
  const std::string xml =
      folder.write("a.xml", R"(<scenefile><object type="tree" name="root"><transblock>)"
                            R"(<object type="primitive" name="mesh" filename="out.mtl"/>)"
                            R"(</transblock></object></scenefile>)");
  const ProgramRun run = run_program({"convert", xml, folder.path("out.obj")});
  EXPECT_EQ(run.status, 2) << run.err;
  EXPECT_EQ(folder.read("out.mtl"), mesh);
}

TEST_F(Convert, CommentsAreCounted) {
  const std::string xml = folder.write("a.xml", "<!-- a -->" + std::string(good_scene));
  EXPECT_THAT(run_program({"convert", xml, folder.path("b.xml")}).err,
              HasSubstr("1 comment is not carried over [convert.comments]"));
}

TEST_F(Convert, AnswersInJson) {
  const std::string xml = folder.write("a.xml", good_scene);
  const ProgramRun run = run_program({"convert", "--json", xml, folder.path("b.json")});
  const rapidjson::Document document = parse_json(run.out);
  EXPECT_TRUE(document["written"].GetBool());
  EXPECT_STREQ(document["format"].GetString(), "json");
  EXPECT_STREQ(document["scene"]["findings"][0]["code"].GetString(), "write.light-id");
  EXPECT_EQ(run.err, "");
}

}  // namespace

}  // namespace scenefile
