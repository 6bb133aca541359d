// render --engine gl: options, output, and scenes that are too large.

#include "app/run_program.h"
#include "scenefile/asset/compare_images.h"
#include "scenefile/asset/image_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::HasSubstr;

struct RenderWithGl : ProgramFolder {
  ProgramRun render(std::vector<std::string> more, const std::string& size = "64x48") const {
    std::vector<std::string> words{"render", scene, "-o", folder.path("gl.png"), "--size", size};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words);
  }
  ProgramRun draw(std::vector<std::string> more) const {
    more.insert(more.end(), {"--engine", "gl"});
    return render(more);
  }
  Texture picture(const std::string& name) const {
    Result<Texture> result = decode_image(folder.read(name));
    EXPECT_EQ(error_text(result), "");
    return result ? *std::move(result) : Texture();
  }
  static bool has_gl(const ProgramRun& run) { return run.status != 3; }

  std::string scene = folder.write("scene.xml", good_scene);
};

TEST_F(RenderWithGl, AnswersInJson) {
  const ProgramRun run = draw({"--json"});
  if (!has_gl(run)) {
    GTEST_SKIP() << run.err;
  }
  EXPECT_EQ(run.status, 0) << run.err;
  const rapidjson::Document json = parse_json(run.out);
  EXPECT_STREQ(json["engine"].GetString(), "gl");
  EXPECT_STRNE(json["renderer"].GetString(), "");
  EXPECT_EQ(json["objects"].GetUint(), 1U);
  EXPECT_EQ(json["draw_calls"].GetUint(), 1U);
  EXPECT_EQ(json["samples"].GetInt(), 4);
  EXPECT_STREQ(parse_json(render({"--json"}).out)["engine"].GetString(), "trace");
}

TEST_F(RenderWithGl, RejectsOptionsOfTheRayTracer) {
  for (const std::vector<std::string>& option :
       std::vector<std::vector<std::string>>{{"--max-depth", "2"},
                                             {"--seed", "1"},
                                             {"--fresnel"},
                                             {"--threads", "2"},
                                             {"--store", folder.path("s")},
                                             {"--aov", "depth"},
                                             {"--crop", "0,0,4,4"},
                                             {"--denoise"}}) {
    const ProgramRun run = draw(option);
    EXPECT_EQ(run.status, 2) << option[0];
    EXPECT_THAT(run.err, HasSubstr(option[0] + " is for the ray tracer"));
  }
  const ProgramRun samples = draw({"--samples", "7"});
  EXPECT_EQ(samples.status, 2);
  EXPECT_THAT(samples.err, HasSubstr("1, 4, 16 or 64"));
  EXPECT_EQ(folder.list(), std::vector<std::string>{"scene.xml"});
}

TEST_F(RenderWithGl, ReportsMissingOpenGl) {
  const ProgramRun run =
      run_program({"render", scene, "--engine", "gl", "-o", folder.path("gl.png")},
                  {.environment = {"__EGL_VENDOR_LIBRARY_DIRS=/none", "DISPLAY="}});
  if (run.status == 0) {
    GTEST_SKIP() << "this EGL needs no vendor files";
  }
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("--engine gl: "));
  EXPECT_EQ(folder.list(), std::vector<std::string>{"scene.xml"});
}

TEST_F(RenderWithGl, ReportsMissingEgl) {
  const std::string libraries = folder.path("lib");
  folder.write("lib/libEGL.so.1", "no library");
  const std::vector<std::string> search{"LD_LIBRARY_PATH=" + libraries};
  const ProgramRun run = run_program(
      {"render", scene, "--engine", "gl", "-o", folder.path("gl.png")}, {.environment = search});
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("--engine gl: there is no EGL (libEGL.so.1)"));
  EXPECT_EQ(run_program({"info", scene}, {.environment = search}).status, 0)
      << "everything else works without EGL";
}

TEST_F(RenderWithGl, TheCourseProfileIsTheTracers) {
  if (const ProgramRun run = draw({"--profile", "course"}); !has_gl(run)) {
    GTEST_SKIP() << run.err;
  }
  ASSERT_EQ(render({"--profile", "course", "-o", folder.path("trace.png")}).status, 0);
  EXPECT_GT(compare_images(picture("gl.png"), picture("trace.png")).psnr_db, 32);
}

TEST_F(RenderWithGl, FloatsAreThePixels) {
  if (const ProgramRun run = draw({}); !has_gl(run)) {
    GTEST_SKIP() << run.err;
  }
  ASSERT_EQ(draw({"-o", folder.path("gl.pfm")}).status, 0);
  // "PF", the size, the byte order; then rows from bottom to top.
  const std::string bytes = folder.read("gl.pfm");
  const Texture pixels = picture("gl.png");
  const std::size_t row = std::size_t{3} * 64;
  ASSERT_GE(bytes.size(), 48 * row * sizeof(float));
  std::vector<float> floats(48 * row);
  std::memcpy(floats.data(), bytes.data() + bytes.size() - floats.size() * sizeof(float),
              floats.size() * sizeof(float));
  for (std::size_t y = 0; y < 48; ++y) {
    for (std::size_t i = 0; i < row; ++i) {
      EXPECT_NEAR(floats[(47 - y) * row + i] * 255, pixels.rgb[y * row + i], 0.01);
    }
  }
}

// Sixteen point lights use all 96 layers.
std::string with_point_lights(int count) {
  std::string text = good_scene;
  const std::size_t at = text.find("  <lightdata>");
  std::string lights;
  for (int i = 1; i <= count; ++i) {
    lights += fmt::format(
        "<lightdata><id v=\"{}\"/><type v=\"point\"/><color r=\"0.1\" g=\"0.1\" b=\"0.1\"/>"
        "<position x=\"{}\" y=\"3\" z=\"3\"/></lightdata>\n",
        i, i);
  }
  return text.insert(at, lights);
}

TEST_F(RenderWithGl, LightsWithoutShadowsAreCounted) {
  for (const int lights : {15, 17}) {
    folder.write("scene.xml", with_point_lights(lights));
    const ProgramRun run = draw({"--features", "shadows"});
    if (!has_gl(run)) {
      GTEST_SKIP() << run.err;
    }
    EXPECT_EQ(run.status, 0);
    // Plus the directional light of the scene.
    EXPECT_EQ(run.err.find("2 of 18 throw no shadows") != std::string::npos, lights == 17)
        << run.err;
    EXPECT_EQ(run.err.find("[gl.shadows-left-out]") != std::string::npos, lights == 17);
  }
  EXPECT_EQ(draw({"--features", "texture"}).err.find("gl.shadows"), std::string::npos);
}

// Each template instantiates the previous one twice.
std::string bomb(int levels) {
  std::string text = R"(<scenefile><cameradata><pos x="0" y="0" z="9"/><look x="0" y="0" z="-1"/>
<up x="0" y="1" z="0"/><heightangle v="45"/></cameradata>
<lightdata><id v="0"/><color r="1" g="1" b="1"/><type v="point"/><position x="3" y="5" z="8"/></lightdata>
<object type="tree" name="t0"><transblock><object type="primitive" name="cube"><diffuse r="1" g="0" b="0"/></object></transblock></object>
)";
  for (int i = 1; i <= levels; ++i) {
    text += fmt::format("<object type=\"tree\" name=\"t{}\">", i);
    for (const char* const side : {"1", "-1"}) {
      text += fmt::format(
          "<transblock><translate x=\"{}\" y=\"0\" z=\"0\"/><object type=\"master\" "
          "name=\"t{}\"/></transblock>",
          side, i - 1);
    }
    text += "</object>\n";
  }
  return text + fmt::format(
                    "<object type=\"tree\" name=\"root\"><transblock><object "
                    "type=\"master\" name=\"t{}\"/></transblock></object></scenefile>",
                    levels);
}

TEST_F(RenderWithGl, ATemplateBombEnds) {
  folder.write("scene.xml", bomb(40));
  const ProgramRun run = draw({});
  if (!has_gl(run)) {
    GTEST_SKIP() << run.err;
  }
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.err, HasSubstr("OpenGL draws the first 1048576"));
  EXPECT_THAT(run.err, HasSubstr("[gl.copies-left-out]"));
}

}  // namespace

}  // namespace scenefile
