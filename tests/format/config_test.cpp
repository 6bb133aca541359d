#include "scenefile/format/codes.h"
#include "scenefile/format/read_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// As written by the public driver.
const std::string good =
    "[IO]\n"
    "\tscene = /scenes/test_unit/unit cone.xml\n"
    "\toutput = /out/test_unit_cone.png\n"
    "\n"
    "[Canvas]\n"
    "\twidth = 1024\n"
    "\theight = 768\n"
    "\n"
    "[Feature]\n"
    "\tshadows = true\n"
    "\treflect = false\n"
    "\tparallel = true\n"
    "\tsuper-sample = true\n"
    "\tacceleration = true\n"
    "\tdepthoffield = false\n"
    "\ttexture-filter = true\n";

struct ConfigReading {
  Diagnostics diagnostics;
  CourseConfig config;

  explicit ConfigReading(const std::string& text, std::optional<ConfigKind> program = std::nullopt)
      : config(read_config(text, {}, diagnostics, program)) {}
  bool gives(const Code& code) const {
    for (const Diagnostic& d : diagnostics.list()) {
      if (d.code == &code) {
        return true;
      }
    }
    return false;
  }
};

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = good;
  text.replace(text.find(from), from.size(), to);
  return text;
}

TEST(Config, AsksForTheSizeInTheSectionOfTheProgram) {
  const std::string text = "[IO]\nscene = a.xml\noutput = a.png\n";
  const auto messages = [&](std::optional<ConfigKind> program) {
    std::string all;
    const ConfigReading read(text, program);
    for (const Diagnostic& d : read.diagnostics.list()) {
      all += d.message + '\n';
    }
    return all;
  };
  using ::testing::HasSubstr;
  EXPECT_THAT(messages(ConfigKind::path), HasSubstr("missing [Settings] imageWidth"));
  EXPECT_THAT(messages(ConfigKind::ray), HasSubstr("missing [Canvas] width"));
  EXPECT_EQ(messages({}),
            "the configuration is missing the size of the picture: [Canvas] width and height for "
            "the ray tracer, [Settings] imageWidth and imageHeight for the path tracer\n");
  EXPECT_EQ(ConfigReading("\xff\xfe[").diagnostics.list()[0].message,
            "the configuration is in UTF-16; save it as UTF-8");
}

TEST(Config, IsReadAsTheDriverWritesIt) {
  const ConfigReading read(good);
  EXPECT_TRUE(read.diagnostics.list().empty());
  CourseConfig expected;
  expected.scene = "/scenes/test_unit/unit cone.xml";
  expected.output = "/out/test_unit_cone.png";
  expected.scene_place = {2, 10};
  expected.output_place = {3, 11};
  expected.width = 1024;
  expected.height = 768;
  expected.features = {"shadows", "super-sample", "texture-filter"};
  EXPECT_EQ(read.config, expected);
}

TEST(Config, ReadsTheSpellingsOfQSettings) {
  const ConfigReading read(
      "\xef\xbb\xbf; comment\r\n# comment\r\n  [ IO ] ; comment\r\n"
      "scene=\"a; \\\"b\\\" \"  c \\\\ \\x20ac\\xe9 ; comment\r\n"
      "output = x.png;y\r\n\r\n[Canvas]\rwidth=1\rheight =65536\n"
      "[Feature]\nshadows=TRUE\nreflect=1\nrefract=0\ntexture=\ntexture-filter = \"true\"\n"
      "[Settings]\nmaximum-recursive-depth=0\nonly-render-normals=true");
  EXPECT_TRUE(read.diagnostics.list().empty());
  EXPECT_EQ(read.config.scene, "a; \"b\"   c \\ \xe2\x82\xac\xc3\xa9");
  EXPECT_EQ(read.config.output, "x.png");
  EXPECT_EQ(read.config.height, 65536);
  EXPECT_THAT(read.config.features, ElementsAre("shadows", "reflect", "texture-filter"));
  EXPECT_EQ(read.config.maximum_recursive_depth, 0);
  EXPECT_TRUE(read.config.only_render_normals);
}

// As in the course's template of the assignment Path.
const std::string good_path =
    "[IO]\n"
    "    scene = example-scenes/CornellBox.xml\n"
    "    output = student_outputs/final/box.png\n"
    "\n"
    "[Settings]\n"
    "    imageWidth = 512\n"
    "    imageHeight = 384\n"
    "    samplesPerPixel = 100\n"
    "    pathContinuationProb = 0.9\n"
    "    directLightingOnly = true\n"
    "    numDirectLightingSamples = 4\n";

std::string replaced_path(const std::string& from, const std::string& to) {
  std::string text = good_path;
  text.replace(text.find(from), from.size(), to);
  return text;
}

TEST(Config, IsRecognizedAsThatOfThePathTracer) {
  const ConfigReading read(good_path);
  EXPECT_TRUE(read.diagnostics.list().empty());
  CourseConfig expected;
  expected.kind = ConfigKind::path;
  expected.scene = "example-scenes/CornellBox.xml";
  expected.output = "student_outputs/final/box.png";
  expected.scene_place = {2, 13};
  expected.output_place = {3, 14};
  expected.width = 512;
  expected.height = 384;
  expected.samples_per_pixel = 100;
  expected.path_continuation_prob = 0.9f;
  expected.direct_lighting_only = true;
  expected.num_direct_lighting_samples = 4;
  EXPECT_EQ(read.config, expected);
}

TEST(Config, MissingKeysOfThePathTracerAreWarnings) {
  const ConfigReading read(
      "[IO]\nscene = a.xml\noutput = a.png\n[Settings]\nimageWidth = 4\nimageHeight = 3\n");
  EXPECT_FALSE(read.diagnostics.has_errors());
  EXPECT_EQ(read.diagnostics.count(Severity::warning), 4u);
  ASSERT_TRUE(read.gives("config.missing-key"_code));
  EXPECT_EQ(read.diagnostics.list()[0].message,
            "the configuration is missing [Settings] samplesPerPixel; it counts as 1");
  EXPECT_EQ(read.diagnostics.list()[1].message,
            "the configuration is missing [Settings] pathContinuationProb; it counts as 0");
  EXPECT_EQ(read.config.kind, ConfigKind::path);
  EXPECT_EQ(read.config.samples_per_pixel, 1);
  EXPECT_EQ(read.config.num_direct_lighting_samples, 1);
  EXPECT_EQ(read.config.path_continuation_prob, 0);
  EXPECT_FALSE(read.config.direct_lighting_only);
}

TEST(Config, ThePathTracerNeedsASize) {
  const ConfigReading read(replaced_path("imageWidth = 512\n", "\n"));
  EXPECT_EQ(read.diagnostics.count(Severity::error), 1u);
  EXPECT_EQ(read.diagnostics.list()[0].message,
            "the configuration is missing [Settings] imageWidth");
}

TEST(Config, KeysOfTheOtherProgramHaveNoEffect) {
  const ConfigReading path(good_path + "[Canvas]\nwidth = 3\n[Feature]\nshadows = true\n");
  EXPECT_EQ(path.diagnostics.count(Severity::warning), 2u);
  EXPECT_EQ(path.diagnostics.list().size(), 2u);
  EXPECT_TRUE(path.gives("config.unknown-key"_code));
  EXPECT_EQ(path.config.width, 512);
  EXPECT_THAT(path.config.features, IsEmpty());
  const ConfigReading ray(good + "[Settings]\nsamplesPerPixel = 0\n");
  EXPECT_EQ(ray.config.kind, ConfigKind::ray);
  ASSERT_EQ(ray.diagnostics.list().size(), 1u);
  EXPECT_EQ(
      ray.diagnostics.list()[0].message,
      "[Settings] samplesPerPixel has no effect: it belongs to the path tracer, and this is a "
      "configuration of the ray tracer");
}

TEST(Config, CountsAreAtLeastOne) {
  const ConfigReading read(replaced_path("Samples = 4", "Samples = 0"));
  EXPECT_FALSE(read.diagnostics.has_errors());
  EXPECT_EQ(read.config.num_direct_lighting_samples, 1);
}

TEST(Config, TheLastOfTwoCounts) {
  const ConfigReading read(replaced("width = 1024", "width = 4\nwidth = 5"));
  EXPECT_EQ(read.config.width, 5);
}

struct ConfigCase {
  const Code* code;
  std::string gives;
  std::string near_miss;
  Location place;
};

class ConfigCode : public ::testing::TestWithParam<ConfigCase> {};

TEST_P(ConfigCode, IsReportedAtItsPlace) {
  const ConfigReading read(GetParam().gives);
  ASSERT_TRUE(read.gives(*GetParam().code));
  for (const Diagnostic& d : read.diagnostics.list()) {
    if (d.code == GetParam().code) {
      EXPECT_EQ(d.location, GetParam().place) << d.message;
      break;
    }
  }
}

TEST_P(ConfigCode, IsNotTriggeredByASimilarFile) {
  EXPECT_TRUE(ConfigReading(GetParam().near_miss).diagnostics.list().empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, ConfigCode,
    ::testing::Values(
        ConfigCase{&"config.syntax"_code,
                   replaced("[Canvas]", "[Canvas"),
                   replaced("[Canvas]", "[ Canvas ]"),
                   {5, 1}},
        ConfigCase{&"config.syntax"_code,
                   replaced("[Canvas]", "[Canvas] x"),
                   replaced("[Canvas]", "[Canvas];x"),
                   {5, 9}},
        ConfigCase{&"config.syntax"_code,
                   replaced("width = 1024", "width 1024\nwidth = 1024"),
                   replaced("width = 1024", "; width 1024\nwidth = 1024"),
                   {6, 2}},
        ConfigCase{&"config.syntax"_code, replaced("width = ", "= "), good, {6, 2}},
        ConfigCase{&"config.syntax"_code,
                   replaced("width = 1024", "width = \"1024"),
                   replaced("width = 1024", "width = \"1024\""),
                   {6, 10}},
        ConfigCase{&"config.backslash"_code,
                   replaced("/out/", "C:\\out\\"),
                   replaced("/out/", "C:\\\\out\\\\"),
                   {3, 13}},
        ConfigCase{&"config.backslash"_code,
                   replaced("/out/", "\\xd800"),
                   replaced("/out/", "\\xd7ff"),
                   {3, 11}},
        ConfigCase{&"config.unknown-key"_code, replaced("shadows =", "shadow ="), good, {10, 2}},
        ConfigCase{&"config.unknown-key"_code, replaced("[Feature]", "[Features]"), good, {10, 2}},
        ConfigCase{&"config.key-case"_code, replaced("[Canvas]", "[canvas]"), good, {6, 2}},
        ConfigCase{&"config.duplicate-key"_code,
                   good + "shadows = false\n",
                   good + "texture = false\n",
                   {17, 1}},
        ConfigCase{&"config.missing-key"_code, replaced("\twidth = 1024\n", ""), good, {0, 0}},
        ConfigCase{&"config.missing-key"_code, "root:x:0:0\n[users]\nsecret = 1\n", good, {0, 0}},
        ConfigCase{&"config.value"_code,
                   replaced("width = 1024", "width = 0"),
                   replaced("width = 1024", "width = 1"),
                   {6, 10}},
        ConfigCase{&"config.value"_code, replaced("width = 1024", "width = 10.5"), good, {6, 10}},
        ConfigCase{&"config.value"_code,
                   replaced_path("= 0.9", "= 1.5"),
                   replaced_path("= 0.9", "= 1"),
                   {9, 28}},
        ConfigCase{&"config.value"_code,
                   replaced_path("= 0.9", "= nan"),
                   replaced_path("= 0.9", "= .5"),
                   {9, 28}},
        ConfigCase{&"config.value"_code,
                   replaced_path("= 100", "= -1"),
                   replaced_path("= 100", "= 65536"),
                   {8, 23}},
        ConfigCase{&"config.value"_code, replaced_path("= 100", "= 65537"), good_path, {8, 23}},
        ConfigCase{&"config.zero"_code,
                   replaced_path("= 100", "= 0"),
                   replaced_path("= 100", "= 1"),
                   {8, 23}},
        ConfigCase{
            &"config.key-case"_code, replaced_path("imageWidth", "imagewidth"), good_path, {6, 5}},
        ConfigCase{&"config.unknown-key"_code, good_path + "threads = 4\n", good_path, {12, 1}},
        ConfigCase{&"config.value"_code,
                   replaced("shadows = true", "shadows = yes"),
                   replaced("shadows = true", "shadows = 1"),
                   {10, 12}},
        ConfigCase{&"config.value"_code, replaced("/out/test_unit_cone.png", ""), good, {3, 11}},
        ConfigCase{&"config.value"_code,
                   good + "[Settings]\nmaximum-recursive-depth = 65\n",
                   good + "[Settings]\nmaximum-recursive-depth = 64\n",
                   {18, 27}}));

TEST(Config, SuggestsCorrections) {
  const ConfigReading read(replaced("shadows =", "shadow ="));
  ASSERT_EQ(read.diagnostics.list().size(), 1U);
  EXPECT_THAT(read.diagnostics.list().front().message,
              HasSubstr("unknown key [Feature] shadow has no effect; did you mean [Feature] "
                        "shadows?"));
}

}  // namespace
}  // namespace scenefile
