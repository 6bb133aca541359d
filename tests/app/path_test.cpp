// render --mode path as a command.

#include "app/run_program.h"
#include "scenefile/asset/image_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

struct PathCommand : ProgramFolder {
  PathCommand() { scene = folder.write("scene.xml", good_scene); }

  ProgramRun render(const std::string& output, const Words& more) const {
    return run_program(Words{"render", scene, "-o", folder.path(output), "--size", "32x24"} + more);
  }

  // The values of a PFM file, which has three lines before them.
  std::vector<float> values(const std::string& name) const {
    const std::string bytes = folder.read(name);
    std::vector<float> numbers(std::size_t{3} * 32 * 24);
    EXPECT_GT(bytes.size(), numbers.size() * sizeof(float));
    std::memcpy(numbers.data(), bytes.data() + bytes.size() - numbers.size() * sizeof(float),
                numbers.size() * sizeof(float));
    return numbers;
  }

  std::string scene;
};

TEST_F(PathCommand, DrawsFrames) {
  const auto frames = [&](const Words& more) {
    return run_program(Words{"frames", scene, "-o", folder.path("f%d.png"), "--turntable", "2",
                             "--size", "32x24", "--mode", "path", "--samples", "4"} +
                       more);
  };
  ASSERT_EQ(frames({}).status, 0);
  ASSERT_EQ(render("a.png", {"--mode", "path", "--samples", "4"}).status, 0);
  const auto pixels = [&](const std::string& name) { return decode_image(folder.read(name))->rgb; };
  EXPECT_EQ(pixels("f1.png"), pixels("a.png"));
  EXPECT_NE(pixels("f2.png"), pixels("a.png"));
  EXPECT_THAT(frames({}).err, HasSubstr("0 of 2 frames drawn, 2 skipped"));
  const ProgramRun brighter = frames({"--exposure", "1"});
  EXPECT_EQ(brighter.status, 1);
  EXPECT_THAT(brighter.err, HasSubstr("the frame was drawn with exposure = 0, not 1"));
}

TEST_F(PathCommand, DrawsASceneWithLights) {
  const ProgramRun run = render("a.png", {"--mode", "path", "--samples", "4"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("4 samples per pixel, "));
  const Result<Texture> picture = decode_image(folder.read("a.png"));
  ASSERT_TRUE(picture);
  EXPECT_GT(picture->texel(16, 12)[0], 60);
  EXPECT_EQ(picture->texel(0, 0)[0], 0);
}

TEST_F(PathCommand, FloatFilesAreLinearWhateverTheTone) {
  const Words path{"--mode", "path", "--samples", "4"};
  render("a.pfm", path);
  render("b.pfm", path + Words{"--tone", "none", "--exposure", "3"});
  EXPECT_EQ(folder.read("a.pfm"), folder.read("b.pfm"));
  render("a.png", path);
  render("b.png", path + Words{"--tone", "none"});
  render("c.png", path + Words{"--tone", "none", "--exposure", "-2"});
  EXPECT_NE(folder.read("a.png"), folder.read("b.png"));
  const Result<Texture> b = decode_image(folder.read("b.png"));
  const Result<Texture> c = decode_image(folder.read("c.png"));
  ASSERT_TRUE(b && c);
  EXPECT_NEAR(b->texel(16, 12)[0] / 4.0, c->texel(16, 12)[0], 1);
}

TEST_F(PathCommand, AnswersInJson) {
  const ProgramRun run = render("a.png", {"--mode", "path", "--json", "--samples", "2"});
  const rapidjson::Document json = parse_json(run.out);
  EXPECT_STREQ(json["mode"].GetString(), "path");
  EXPECT_EQ(json["samples"].GetInt(), 2);
  EXPECT_EQ(json["max_depth"].GetInt(), 0);
  EXPECT_EQ(json["light_samples"].GetInt(), 1);
  EXPECT_STREQ(json["convention"].GetString(), "physics");
  EXPECT_FALSE(json.HasMember("features"));
  const rapidjson::Document ray = parse_json(render("a.png", {"--json"}).out);
  EXPECT_FALSE(ray.HasMember("light_samples"));
}

TEST_F(PathCommand, TimeGivesTheSamplesThatReproduceIt) {
  const ProgramRun run = render("a.pfm", {"--mode", "path", "--time", "0.3", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const int samples = parse_json(run.out)["samples"].GetInt();
  EXPECT_GE(samples, 1);
  render("b.pfm", {"--mode", "path", "--samples", std::to_string(samples)});
  EXPECT_EQ(folder.read("a.pfm"), folder.read("b.pfm"));
}

TEST_F(PathCommand, OptionsReachThePaths) {
  // Light that one cube reflects to the other differs by all of these.
  folder.write("scene.xml", R"(<scenefile><globaldata><ambientcoeff v="0.5"/><diffusecoeff v="1"/>
<specularcoeff v="0.5"/></globaldata><cameradata><pos x="0" y="3" z="6"/><focus x="0" y="0" z="0"/>
<up x="0" y="1" z="0"/><heightangle v="45"/></cameradata>
<lightdata><id v="0"/><type v="point"/><color r="1" g="1" b="1"/><position x="3" y="4" z="4"/>
<function a="1" b="0" c="0"/></lightdata>
<object type="tree" name="root">
<transblock><translate x="0" y="-1" z="0"/><scale x="6" y="1" z="6"/><object type="primitive"
name="cube"><diffuse r="1" g="0.8" b="0.6"/></object></transblock>
<transblock><object type="primitive" name="cube"><diffuse r="0.6" g="0.8" b="1"/></object></transblock>
</object></scenefile>)");
  const Words path{"--mode", "path", "--samples", "2"};
  ASSERT_EQ(render("a.pfm", path).status, 0);
  const std::string usual = folder.read("a.pfm");
  for (const Words& more : {Words{"--seed", "1"}, Words{"--max-depth", "1"}, Words{"--direct-only"},
                            Words{"--clamp", "0.001"}, Words{"--continue", "0.5"}}) {
    EXPECT_EQ(render("b.pfm", path + more).status, 0);
    EXPECT_NE(folder.read("b.pfm"), usual) << more[0];
  }
}

TEST_F(PathCommand, RefusesWhatItDoesNotHave) {
  const Words path{"--mode", "path"};
  for (const Words& more :
       {Words{"--fresnel"}, Words{"--min-samples", "2"}, Words{"--features", "none"},
        Words{"--engine", "gl"}, Words{"--profile", "course"}, Words{"--profile", "realtime"}}) {
    const ProgramRun run = render("a.png", path + more);
    EXPECT_EQ(run.status, 2) << more[0] << run.err;
    EXPECT_THAT(run.err, HasSubstr("--mode")) << more[0];
  }
  for (const Words& more : {Words{"--light-samples", "2"}, Words{"--direct-only"},
                            Words{"--time", "1"}, Words{"--tone", "none"}}) {
    const ProgramRun run = render("a.png", Words{"--mode", "ray"} + more);
    EXPECT_EQ(run.status, 2) << more[0] << run.err;
    EXPECT_THAT(run.err, HasSubstr("leave it out, or --mode ray")) << more[0];
  }
  const ProgramRun reference =
      run_program({"explain", scene, "--pixel", "5,5", "--mode", "path", "--mine",
                   folder.path("a.png"), "--reference", folder.path("b.png")});
  EXPECT_EQ(reference.status, 2);
  EXPECT_THAT(reference.err, HasSubstr("--reference has no effect on paths"));
}

TEST_F(PathCommand, TheNoiseOfOneSampleIsUnknown) {
  const Words words{"explain", scene, "--pixel", "5,5", "--mode", "path", "--samples", "1"};
  EXPECT_THAT(run_program(words).out, HasSubstr("standard error unknown"));
  EXPECT_THAT(run_program(words + Words{"--json"}).out, HasSubstr("\"standard_error\": null"));
}

TEST_F(PathCommand, ExplainsThePixelsAroundOneOfMine) {
  ASSERT_EQ(render("mine.pfm", {"--mode", "path", "--samples", "16"}).status, 0);
  const ProgramRun mine = run_program({"explain", scene, "--pixel", "5,5", "--mine",
                                       folder.path("mine.pfm"), "--mode", "path", "--time", "1"});
  EXPECT_EQ(mine.status, 0) << mine.err;
  EXPECT_THAT(mine.out, AllOf(HasSubstr("yours at 0,0..7,7: "), HasSubstr("the truth ")));
}

TEST_F(PathCommand, IsImpliedByItsOptionsAndLayers) {
  folder.write("scene.xml", R"(<scenefile><globaldata><ambientcoeff v="0.5"/>
<diffusecoeff v="1"/><specularcoeff v="0.5"/></globaldata><cameradata><pos x="0" y="3" z="6"/>
<focus x="0" y="0" z="0"/><up x="0" y="1" z="0"/><heightangle v="45"/></cameradata>
<lightdata><id v="0"/><type v="point"/><color r="1" g="1" b="1"/><position x="3" y="4" z="4"/>
<function a="1" b="0" c="0"/></lightdata>
<object type="tree" name="root"><transblock><object type="primitive" name="cube">
<diffuse r="0.6" g="0.8" b="1"/></object></transblock></object></scenefile>)");
  const Words samples{"--samples", "2"};
  ASSERT_EQ(render("a.pfm", samples + Words{"--mode", "path", "--light-samples", "2"}).status, 0);
  EXPECT_EQ(render("b.pfm", samples + Words{"--light-samples", "2"}).status, 0);
  EXPECT_EQ(folder.read("a.pfm"), folder.read("b.pfm"));
  EXPECT_EQ(render("c.exr", samples + Words{"--aov", "variance"}).status, 0);
  const ProgramRun both = render("d.png", {"--light-samples", "2", "--fresnel"});
  EXPECT_EQ(both.status, 2);
  EXPECT_THAT(both.err, HasSubstr("--fresnel has no effect on paths"));
}

TEST_F(PathCommand, WritesLayersAndDenoises) {
  const Words path{"--mode", "path", "--samples", "4"};
  ASSERT_EQ(render("plain.png", path).status, 0);
  const ProgramRun png = render("a.png", path + Words{"--aov", "direct,bounce-2,samples"});
  EXPECT_EQ(png.status, 0) << png.err;
  EXPECT_EQ(folder.read("a.png"), folder.read("plain.png"));
  for (const char* const name : {"a.direct.png", "a.bounce-2.png", "a.samples.png"}) {
    EXPECT_TRUE(decode_image(folder.read(name))) << name;
  }
  const Result<Texture> direct = decode_image(folder.read("a.direct.png"));
  ASSERT_TRUE(direct);
  EXPECT_GT(direct->texel(16, 12)[0], 60);
  EXPECT_EQ(decode_image(folder.read("a.samples.png"))->texel(3, 3)[0], 255);
  if (SCENEFILE_OPENEXR) {
    EXPECT_EQ(render("a.exr", path + Words{"--aov", "specular,variance", "--denoise"}).status, 0);
    EXPECT_THAT(folder.read("a.exr"), AllOf(HasSubstr("specular.R"), HasSubstr("variance.Y")));
  }
  ASSERT_EQ(render("d.png", path + Words{"--denoise"}).status, 0);
  // The same from a store, in shares.
  const Words stored =
      path + Words{"--aov", "direct,variance", "--denoise", "--store", folder.path("store")};
  for (const char* const share : {"1/2", "2/2"}) {
    const ProgramRun part = render("s.png", stored + Words{"--part", share});
    EXPECT_EQ(part.status, 0) << part.err;
  }
  ASSERT_EQ(render("s.png", stored).status, 0);
  ASSERT_EQ(render("w.png", path + Words{"--aov", "direct,variance", "--denoise"}).status, 0);
  EXPECT_EQ(folder.read("w.png"), folder.read("d.png"));
  for (const std::string name : {"", ".direct", ".variance"}) {
    const Result<Texture> assembled = decode_image(folder.read("s" + name + ".png"));
    const Result<Texture> whole = decode_image(folder.read("w" + name + ".png"));
    ASSERT_TRUE(assembled && whole) << name;
    EXPECT_TRUE(assembled->rgb == whole->rgb) << name;
  }
  const ProgramRun depth = render("b.png", path + Words{"--aov", "normal,depth"});
  EXPECT_EQ(depth.status, 2);
  EXPECT_THAT(depth.err, HasSubstr("mode path has no layer depth; it has normal, albedo, direct, "
                                   "bounce-1, specular, variance, samples\n"));
  const ProgramRun ray = render("b.png", {"--mode", "ray", "--aov", "bounce-3"});
  EXPECT_EQ(ray.status, 2);
  EXPECT_THAT(ray.err, HasSubstr("bounce-3 is a layer of path tracing"));
  EXPECT_EQ(render("b.png", path + Words{"--aov", "bounce-x"}).status, 2);
  EXPECT_EQ(render("b.png", path + Words{"--aov", "bounce-01"}).status, 2);
}

TEST_F(PathCommand, ExplainsAPixel) {
  const Words options{"--mode", "path", "--samples", "5", "--size", "32x24"};
  const Words words = Words{"explain", scene, "--pixel", "16,12"} + options;
  const ProgramRun run = run_program(words + Words{"--sample", "2"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("pixel 16,12 of 32x24, mode path"), HasSubstr("samples 5"),
                             HasSubstr("sample 2: "), HasSubstr("vertex 0: hits sphere root/#1"),
                             HasSubstr("directional light (line 9)"), HasSubstr("no occluder"),
                             HasSubstr("continues diffuse"), HasSubstr("hits nothing"),
                             HasSubstr("sum "), Not(HasSubstr("\x1b"))));
  EXPECT_EQ(run_program(words + Words{"--sample", "5"}).status, 2);

  const rapidjson::Document json = parse_json(run_program(words + Words{"--json"}).out);
  EXPECT_STREQ(json["mode"].GetString(), "path");
  const auto& pixel = json["pixel"];
  ASSERT_EQ(pixel["samples"].Size(), 5u);
  render("a.pfm", options);
  const std::vector<float> picture = values("a.pfm");
  // Rows of PFM files are stored from the bottom up.
  const std::size_t at = 3 * ((24 - 1 - 12) * 32 + 16);
  for (unsigned c = 0; c < 3; ++c) {
    double sum = 0;
    for (const auto& sample : pixel["samples"].GetArray()) {
      sum += sample["color"][c].GetDouble();
    }
    EXPECT_EQ(static_cast<float>(sum / 5), picture[at + c]);
    EXPECT_EQ(static_cast<float>(pixel["color"][c].GetDouble()), picture[at + c]);
    EXPECT_EQ(pixel["path"]["color"][c].GetDouble(),
              pixel["samples"][pixel["shown"].GetUint()]["color"][c].GetDouble());
  }
  const ProgramRun outside = run_program(Words{"explain", scene, "--pixel", "0,0"} + options);
  EXPECT_THAT(outside.out, HasSubstr("the background is black"));
}

// A lamp over a floor, in the files of the assignment Path.
TEST_F(PathCommand, IsTheDefaultForFacesThatEmitLight) {
  folder.write("box.mtl", "newmtl white\r\nKd .7 .7 .7\r\nnewmtl lamp\r\nKe 3 3 3\r\n");
  folder.write("box.obj",
               "mtllib box.mtl\nv -9 0 9\nv 9 0 9\nv 9 0 -9\nv -9 0 -9\n"
               "v -1 3 -1\nv 1 3 -1\nv 1 3 1\nv -1 3 1\n"
               "usemtl white\nf 1 2 3 4\nusemtl lamp\nf 5 6 7 8\n");
  scene = folder.write("lamp.xml", R"(<scenefile>
  <cameradata><pos x="0" y="2" z="6"/><focus x="0" y="0" z="0"/><up x="0" y="1" z="0"/>
    <heightangle v="45"/></cameradata>
  <object type="tree" name="root"><transblock>
    <object type="primitive" name="mesh" filename="box.obj"/>
  </transblock></object>
</scenefile>
)");
  const ProgramRun run = render("a.pfm", {"--samples", "16"});
  const ProgramRun explained =
      run_program({"explain", scene, "--pixel", "16,12", "--size", "32x24", "--samples", "3"});
  EXPECT_EQ(explained.status, 0);
  EXPECT_THAT(explained.err, AllOf(HasSubstr("using --mode path"), Not(HasSubstr("warning"))));
  EXPECT_THAT(explained.out, AllOf(HasSubstr("material white (box.mtl:1), illum 0"),
                                   HasSubstr("lamp "), HasSubstr("density ")));
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, AllOf(HasSubstr("using --mode path"), HasSubstr("16 samples per pixel"),
                             Not(HasSubstr("warning"))));
  EXPECT_GT(values("a.pfm")[3 * (32 * 12 + 16)], 0.05);
  // The same as if it was given, but not with options of the other modes.
  const ProgramRun given = render("b.pfm", {"--samples", "16", "--mode", "path"});
  EXPECT_THAT(given.err, Not(HasSubstr("using --mode path")));
  EXPECT_EQ(folder.read("a.pfm"), folder.read("b.pfm"));
  const ProgramRun fresnel = render("c.png", {"--fresnel"});
  EXPECT_THAT(fresnel.err, HasSubstr("note: --fresnel is not for path tracing"));
  EXPECT_THAT(fresnel.err, Not(HasSubstr("using --mode path")));
  EXPECT_THAT(render("c.png", {"--mode", "ray"}).err, Not(HasSubstr("using --mode path")));
}

}  // namespace

}  // namespace scenefile
