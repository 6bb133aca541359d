// Scenes of the assignment Path: no lights, but faces of meshes that emit light.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::string_view box =
    "mtllib box.mtl\n"
    "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -1 -1 1\nv 1 -1 1\nvt 0 0\nvt 1 0\nvt 1 1\n"
    "usemtl wall\nf 1/1 2/2 3/3 4/1\n"
    "usemtl lamp\nf 2 1 5 6\n";
constexpr std::string_view library =
    "newmtl lamp\nKe 17 12 4\nKd 0.5 0.5 0.5\n"
    "newmtl wall\nKd 0.25 0.5 0.75\nmap_Kd wood.png\nNs 10\nillum 2\n";

struct PathScene : ProgramFolder {
  PathScene() {
    folder.write("scenes/models/box.obj", std::string(box));
    folder.write("scenes/models/box.mtl", std::string(library));
    std::filesystem::copy(std::filesystem::path(SCENEFILE_FIXTURES) / "codes/image/rgb.png",
                          folder.path("scenes/models/wood.png"));
  }

  // A scene with the mesh, and with `lights`.
  std::string scene(const std::string& lights = "") const {
    return folder.write(
        "scenes/s.xml",
        R"(<scenefile><cameradata><pos x="0" y="0" z="5"/><look x="0" y="0" z="-1"/>)"
        R"(<up x="0" y="1" z="0"/><heightangle v="40"/></cameradata>)" +
            lights +
            R"(<object type="tree" name="root"><transblock><object type="primitive" name="mesh" )"
            R"(filename="models/box.obj"/></transblock></object></scenefile>)");
  }
};

// The findings, or nothing if there is none.
std::string check(const std::string& path, const Words& options = {}) {
  const ProgramRun run = run_program(Words{"check", path} + options);
  EXPECT_EQ(run.status, 0);
  return run.out == path + ": fine\n" ? "" : run.out;
}

const std::string point_light =
    R"(<lightdata><id v="0"/><type v="point"/><color r="1" g="1" b="1"/>)"
    R"(<position x="0" y="0" z="5"/><function v1="1" v2="0" v3="0"/></lightdata>)";

TEST_F(PathScene, HasNoFindings) {
  EXPECT_EQ(check(scene()), "");
}

TEST_F(PathScene, WithoutEmissionItHasNoLight) {
  folder.write("scenes/models/box.mtl", "newmtl lamp\nnewmtl wall\n");
  EXPECT_THAT(run_program({"check", scene()}).out, HasSubstr("[scene.no-light]"));
}

TEST_F(PathScene, ItsFacesMayEmitLightIfTheyCannotBeRead) {
  const std::string path = scene();
  for (const std::string mesh : {"f 1 2 3\n", ""}) {
    mesh.empty() ? static_cast<void>(std::filesystem::remove(folder.path("scenes/models/box.obj")))
                 : static_cast<void>(folder.write("scenes/models/box.obj", mesh));
    const ProgramRun run = run_program({"check", path});
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.out, Not(HasSubstr("scene.no-light")));
  }
}

TEST_F(PathScene, FindingsHaveThePlaceInTheLibrary) {
  folder.write("scenes/models/box.mtl",
               "newmtl lamp\nKe 17 12 4\nNs x\nnewmtl wall\nKd 1 1 1\nKs 1 1 1\n");
  const ProgramRun run = run_program({"check", scene()});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.out, HasSubstr("models/box.mtl:3:4: warning: \"x\" in Ns is not a number"));
  EXPECT_THAT(run.out,
              HasSubstr("models/box.mtl:4:1: note: Kd + Ks of the material \"wall\" is 2"));
  EXPECT_THAT(run.out, Not(HasSubstr("Ns x"))) << "contents of other files are not shown";
  const rapidjson::Document sarif = parse_json(run_program({"check", "--sarif", scene()}).out);
  const auto& result = sarif["runs"][0]["results"][0];
  EXPECT_THAT(result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"].GetString(),
              HasSubstr("scenes/models/box.mtl"));
}

// What is exported as OBJ is drawn like the scene: the same triangles with the same materials.
TEST_F(PathScene, AnExportedSceneIsDrawnAlike) {
  folder.write("scenes/models/box.mtl", "newmtl lamp\nKe 17 12 4\nnewmtl wall\nKd .25 .5 .75\n");
  const std::string written = scene();
  const auto picture = [&](const std::string& path) {
    const ProgramRun run = run_program(
        {"render", path, "-o", folder.path("p.png"), "--size", "24x24", "--samples", "4", "-q"});
    EXPECT_EQ(run.status, 0) << run.err;
    return folder.read("p.png");
  };
  const std::string before = picture(written);
  EXPECT_EQ(run_program({"convert", written, folder.path("scenes/models/box2.obj")}).status, 0);
  std::string text = folder.read("scenes/s.xml");
  text.replace(text.find("box.obj"), 7, "box2.obj");
  folder.write("scenes/s.xml", text);
  EXPECT_EQ(picture(written), before);
  const ProgramRun glb = run_program({"convert", "--to", "gltf", written, "-"});
  EXPECT_THAT(glb.out, HasSubstr(R"("emissiveStrength":17)"));
}

TEST_F(PathScene, ImportSaysThatEmissionIsLost) {
  const std::string written = scene();
  for (const std::string model : {"back.obj", "back.glb"}) {
    ASSERT_EQ(run_program({"convert", written, folder.path(model)}).status, 0);
    const ProgramRun back = run_program({"convert", folder.path(model), folder.path("again.xml")});
    EXPECT_EQ(back.status, 0);
    EXPECT_THAT(back.err, HasSubstr("what materials emit becomes their ambient color")) << model;
    EXPECT_THAT(folder.read("again.xml"), HasSubstr(R"(<ambient r="17" g="12" b="4"/>)")) << model;
  }
}

TEST_F(PathScene, FramesArePathTraced) {
  const ProgramRun run = run_program({"frames", scene(), "-o", folder.path("f%d.pfm"),
                                      "--turntable", "1", "--size", "24x24", "--samples", "4"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.err, HasSubstr("using --mode path"));
  ASSERT_EQ(run_program({"render", scene(), "-o", folder.path("p.pfm"), "--size", "24x24",
                         "--samples", "4"})
                .status,
            0);
  EXPECT_THAT(folder.read("f1.pfm"), ::testing::StartsWith(folder.read("p.pfm")));
  // What only path tracing has selects it.
  const ProgramRun layers =
      run_program({"frames", scene(), "-o", folder.path("l%d.png"), "--turntable", "1", "--size",
                   "8x8", "--samples", "1", "--direct-only", "--aov", "direct"});
  EXPECT_EQ(layers.status, 0) << layers.err;
}

TEST_F(PathScene, WithLightsMaterialsAreNotRead) {
  folder.write("scenes/models/box.mtl", "nonsense");
  const std::string path = scene(point_light);
  EXPECT_EQ(check(path), "");
  EXPECT_THAT(run_program({"info", "--files", path}).out, Not(HasSubstr("box.mtl")));
}

TEST_F(PathScene, InfoListsMaterials) {
  const ProgramRun run = run_program({"info", "--files", scene()});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("  face materials of models/box.obj\n"
                                 "    wall: 2 triangles, Kd 0.25 0.5 0.75, Ns 10, Ni 1, illum 2\n"
                                 "    lamp: 2 triangles, Ke 17 12 4, Kd 0.5 0.5 0.5, Ns 1, Ni 1, "
                                 "illum 0\n"));
  EXPECT_THAT(run.out, HasSubstr("textures    1\n"));
  EXPECT_THAT(run.out, HasSubstr("library \"models/box.mtl\" (line 1 of models/box.obj): next to "
                                 "the scene: " +
                                 folder.path("scenes/models/box.mtl")));
  EXPECT_THAT(run.out, HasSubstr("texture \"models/wood.png\" (line 6 of models/box.mtl): "));
}

TEST_F(PathScene, InfoListsMaterialsInJson) {
  const rapidjson::Document info = parse_json(run_program({"info", "--json", scene()}).out);
  ASSERT_EQ(info["face_materials"].Size(), 2u);
  const auto& lamp = info["face_materials"][1];
  EXPECT_STREQ(lamp["mesh"].GetString(), "models/box.obj");
  EXPECT_STREQ(lamp["name"].GetString(), "lamp");
  EXPECT_STREQ(lamp["file"].GetString(), "models/box.mtl");
  EXPECT_EQ(lamp["line"].GetInt(), 1);
  EXPECT_EQ(lamp["triangles"].GetInt(), 2);
  EXPECT_EQ(lamp["emission"][0].GetDouble(), 17);
  ASSERT_EQ(info["files"].Size(), 3u);
  EXPECT_STREQ(info["files"][1]["kind"].GetString(), "library");
  EXPECT_STREQ(info["files"][1]["file"].GetString(), "models/box.obj");
  EXPECT_TRUE(info["files"][2]["found"].GetBool());
}

TEST_F(PathScene, OtherModesSayThatTheyDoNotDrawItsLight) {
  const std::string path = scene();
  const ProgramRun run =
      run_program({"render", path, "--mode", "ray", "--size", "4x4", "-o", folder.path("out.png")});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.err, HasSubstr("which only --mode path draws [scene.no-light]"));
  EXPECT_THAT(run_program({"render", path, "--mode", "normals", "--size", "4x4", "-o",
                           folder.path("out.png")})
                  .err,
              Not(HasSubstr("scene.no-light")));
}

TEST_F(PathScene, LibrariesOutsideTheRootsAreNotRead) {
  folder.write("secret.mtl", std::string(library));
  std::string mesh(box);
  mesh.replace(mesh.find("box.mtl"), 7, "../../secret.mtl");
  folder.write("scenes/models/box.obj", mesh);
  const ProgramRun run = run_program({"check", scene()});
  EXPECT_THAT(run.out, HasSubstr("models/box.obj:1:8: warning: the material library "
                                 "\"../../secret.mtl\": no such file"));
  EXPECT_THAT(run.out, HasSubstr("[mtl.missing]"));
  EXPECT_EQ(check(scene(), {"--allow-outside"}), "");
}

// The case of folders and absolute paths do not matter, as for textures and meshes.
TEST_F(PathScene, LibrariesAreFoundByTheRulesOfAssets) {
  for (const std::string name : {"Box.MTL", "C:\\Users\\me\\models\\box.mtl", "/course/box.mtl"}) {
    std::string mesh(box);
    mesh.replace(mesh.find("box.mtl"), 7, name);
    folder.write("scenes/models/box.obj", mesh);
    EXPECT_EQ(check(scene()), "") << name;
  }
}

TEST_F(PathScene, ConvertsWithItsFiles) {
  const std::string path = scene();
  const ProgramRun run = run_program({"convert", path, folder.path("scenes/s.json")});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(check(folder.path("scenes/s.json")), "");
}

// A room corner with a lamp that faces it.
TEST_F(PathScene, PicturesAreJudgedWithinTheirNoise) {
  const std::string path = scene();
  const Words size{"--size", "64x64", "--samples", "128"};
  const std::string mine = folder.path("mine.pfm");
  ASSERT_EQ(run_program(Words{"render", path, "-o", mine, "--seed", "3", "-q"} + size).status, 0);
  const ProgramRun right = run_program({"diff", mine, "--scene", path, "--time", "0.5"});
  EXPECT_EQ(right.status, 0) << right.out << right.err;
  EXPECT_THAT(right.out, HasSubstr("right within its noise\n"));
  const ProgramRun both =
      run_program({"diff", mine, mine, "--scene", path, "--time", "0.5", "--energy",
                   folder.path("light.svg"), "--sheet", folder.path("sheet.png"), "--json"});
  EXPECT_EQ(both.status, 0) << both.err;
  EXPECT_THAT(both.out, HasSubstr("\"reference_path\": {"));
  EXPECT_THAT(folder.read("light.svg"), HasSubstr("</svg>"));

  const std::string other = folder.path("other.pfm");
  ASSERT_EQ(
      run_program(Words{"render", path, "-o", other, "--convention", "course", "-q"} + size).status,
      0);
  const ProgramRun wrong = run_program({"diff", other, "--scene", path, "--time", "0.5"});
  EXPECT_EQ(wrong.status, 1) << wrong.out;
  EXPECT_EQ(run_program({"diff", other, "--scene", path, "--time", "0.5", "--convention", "course"})
                .status,
            0);
}

TEST_F(PathScene, PicturesWithoutReferenceNeedTheScene) {
  const std::string path = scene(point_light);
  const std::string mine = folder.path("mine.png");
  ASSERT_EQ(run_program({"render", path, "-o", mine, "--size", "24x24", "-q"}).status, 0);
  EXPECT_EQ(run_program({"diff", mine}).status, 2);
  EXPECT_EQ(run_program({"diff", mine, "--scene", path}).status, 2);  // ray traced
  EXPECT_EQ(run_program({"diff", mine, mine, "--mode", "path"}).status, 2);
  const ProgramRun implied = run_program({"diff", mine, mine, "--direct-only"});
  EXPECT_EQ(implied.status, 2);
  EXPECT_THAT(implied.err, HasSubstr("--direct-only needs the scene: --scene SCENE"));
  EXPECT_EQ(run_program({"diff", path}).status, 2);
}

}  // namespace

}  // namespace scenefile
