#include "app/run_program.h"
#include "scenefile/asset/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Texture decode(const std::string& bytes) {
  Result<Texture> picture = decode_image(bytes);
  EXPECT_EQ(error_text(picture), "");
  return picture ? *std::move(picture) : Texture();
}

struct Render : ProgramFolder {
  Render() { scene = folder.write("scene.xml", good_scene); }

  // Renders a small picture to out.png.
  ProgramRun render(std::vector<std::string> more, const RunSettings& settings = {}) const {
    std::vector<std::string> words{"render", scene,  "-o", folder.path("out.png"),
                                   "--size", "32x24"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words, settings);
  }

  std::string scene;
};

TEST_F(Render, AnOutputThatCannotBeWrittenIsAnAnswerInJson) {
  const ProgramRun run =
      run_program({"render", scene, "-o", folder.path("none/out.png"), "--json"});
  EXPECT_NE(run.status, 0);
  EXPECT_THAT(run.out, AllOf(HasSubstr("\"written\": false"), HasSubstr("\"error\": ")));
}

TEST_F(Render, WritesAPictureOfTheSize) {
  const ProgramRun run = render({});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, AllOf(HasSubstr("out.png: 32x24, "), HasSubstr("million rays"),
                             Not(HasSubstr("\r"))));
  const Texture picture = decode(folder.read("out.png"));
  EXPECT_EQ(picture.width, 32);
  EXPECT_EQ(picture.height, 24);
  EXPECT_GT(picture.texel(16, 12)[0], 60);
  EXPECT_EQ(picture.texel(0, 0)[0], 0);
  EXPECT_THAT(folder.list(), ElementsAre("out.png", "scene.xml"));
}

TEST_F(Render, QuietPrintsNothing) {
  const ProgramRun run = render({"--quiet"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out + run.err, "");
}

TEST_F(Render, OptionsReachTheTracer) {
  render({"--mode", "normals"});
  const std::string normals = folder.read("out.png");
  render({"--mode", "intersect"});
  const std::string caster = folder.read("out.png");
  render({"--profile", "course", "--features", "none", "--max-depth", "0", "--threads", "2"});
  const std::string course = folder.read("out.png");
  EXPECT_NE(normals, caster);
  EXPECT_NE(caster, course);
  EXPECT_GT(decode(normals).texel(16, 12)[2], 200);
}

TEST_F(Render, StandardOutputContainsOnlyThePicture) {
  const ProgramRun run =
      run_program({"render", "-", "-o", "-", "--size", "16x16"}, {.input = good_scene});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(decode(run.out).width, 16);
  EXPECT_THAT(run.err, HasSubstr("<stdout>: 16x16"));
}

TEST_F(Render, OtherFormatsByName) {
  for (const auto& [name, start] : {std::pair<std::string, std::string>{"out.pfm", "PF\n16 16\n"},
                                    {"out.EXR", "\x76\x2f\x31\x01"}}) {
    const ProgramRun run =
        run_program({"render", scene, "-o", folder.path(name), "--size", "16x16"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(folder.read(name).starts_with(start)) << name;
  }
}

TEST_F(Render, JsonIsOneDocument) {
  const ProgramRun run = render({"--json", "--features", "shadows,texture"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
  const rapidjson::Document report = parse_json(run.out);
  EXPECT_TRUE(report["written"].GetBool());
  EXPECT_EQ(report["width"].GetInt(), 32);
  EXPECT_EQ(report["features"].Size(), 2U);
  EXPECT_GE(report["primary_rays"].GetInt(), 32 * 24);
}

TEST_F(Render, FailuresHaveAJsonDocumentToo) {
  folder.write("scene.xml", "<scenefile>");
  const ProgramRun run = render({"--json"});
  EXPECT_EQ(run.status, 1);
  const rapidjson::Document report = parse_json(run.out);
  EXPECT_FALSE(report["written"].GetBool());
  EXPECT_EQ(report["scene"]["errors"].GetInt(), 1);
  EXPECT_THAT(folder.list(), ElementsAre("scene.xml"));
}

TEST_F(Render, ABrokenSceneKeepsTheOldPicture) {
  folder.write("scene.xml", "<scenefile>");
  folder.write("out.png", "old");
  const ProgramRun run = render({});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("scene.xml: 1 error"));
  EXPECT_EQ(folder.read("out.png"), "old");
  EXPECT_THAT(folder.list(), ElementsAre("out.png", "scene.xml"));
}

TEST_F(Render, TheOutputIsCheckedBeforeTheScene) {
  const ProgramRun missing =
      run_program({"render", folder.path("none.xml"), "-o", folder.path("no/such/out.png")});
  EXPECT_EQ(missing.status, 3);
  EXPECT_THAT(missing.err, AllOf(HasSubstr("no/such"), Not(HasSubstr("none.xml"))));
  std::filesystem::create_directories(folder.path("dir.png"));
  const ProgramRun dir = run_program({"render", scene, "-o", folder.path("dir.png")});
  EXPECT_EQ(dir.status, 3);
  EXPECT_THAT(dir.err, HasSubstr("it is a directory"));
}

TEST_F(Render, NeverReplacesTheScene) {
  const std::string odd = folder.write("scene.png", good_scene);
  const ProgramRun run = run_program({"render", odd, "-o", folder.path("./scene.png")});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("would replace the scene"));
  EXPECT_EQ(folder.read("scene.png"), good_scene);
}

TEST_F(Render, WarnsAboutBlackPictures) {
  std::string dark = good_scene;
  dark.replace(dark.find("\"directional\""), 13, "\"point\"");
  dark.replace(dark.find("direction"), 9, "position");
  folder.write("scene.xml", dark);
  EXPECT_THAT(render({}).err, Not(HasSubstr("warning")));
  EXPECT_THAT(render({"--mode", "intersect"}).err, Not(HasSubstr("warning")));
  EXPECT_THAT(render({"--mode", "intersect", "--profile", "course"}).err,
              HasSubstr("[render.no-directional-light]"));
  const std::size_t start = dark.find("  <lightdata>");
  dark.erase(start, dark.find("</lightdata>") + 13 - start);
  folder.write("scene.xml", dark);
  EXPECT_THAT(render({}).err, HasSubstr("[scene.no-light]"));
}

TEST_F(Render, WarnsAboutADefaultCoefficient) {
  folder.write("scene.xml", scene_with(R"(<transparent r="1" g="1" b="1"/>)"));
  const std::string code = "[global.transparent-default]";
  EXPECT_THAT(render({}).err, HasSubstr(code));
  EXPECT_THAT(render({"--profile", "course"}).err, Not(HasSubstr(code)));
  EXPECT_THAT(render({"--features", "shadows"}).err, Not(HasSubstr(code)));
  std::string given = scene_with(R"(<transparent r="1" g="1" b="1"/>)");
  given.replace(given.find("<specularcoeff"), 0, R"(<transparentcoeff v="0.3"/>)");
  folder.write("scene.xml", given);
  EXPECT_THAT(render({}).err, Not(HasSubstr(code)));
}

TEST_F(Render, WarnsAboutMaterialsThatAddLightInModePath) {
  folder.write("scene.xml",
               scene_with(R"(<diffuse r="1" g="1" b="1"/><reflective r="1.5" g="0" b="0"/>)"));
  const std::string code = "[material.energy]";
  EXPECT_THAT(render({}).err, Not(HasSubstr(code)));
  EXPECT_THAT(render({"--mode", "path", "--samples", "1"}).err, HasSubstr(code));
}

TEST_F(Render, AMissingMeshIsAnErrorUnlessAllowed) {
  std::string mesh = good_scene;
  mesh.replace(mesh.find("name=\"sphere\""), 13, "name=\"mesh\" filename=\"no.obj\"");
  folder.write("scene.xml", mesh);
  const ProgramRun refused = render({});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("no.obj"));
  const ProgramRun drawn = render({"--allow-missing"});
  EXPECT_EQ(drawn.status, 0);
  EXPECT_THAT(drawn.err, HasSubstr("no.obj"));
}

TEST_F(Render, AssetRootsAreSearched) {
  render({});
  const TempFolder elsewhere;
  elsewhere.write("image/p.png", folder.read("out.png"));
  folder.write("scene.xml",
               scene_with(R"(<blend v="1"/><texture file="image/p.png" u="1" v="1"/>)"));
  EXPECT_THAT(render({}).err, HasSubstr("image/p.png"));
  EXPECT_THAT(render({"--asset-root", elsewhere.path()}).err, Not(HasSubstr("warning")));
  const ProgramRun data = render({}, {.environment = {"CS123_DATA=" + elsewhere.path()}});
  EXPECT_THAT(data.err, Not(HasSubstr("warning")));
}

}  // namespace

}  // namespace scenefile
