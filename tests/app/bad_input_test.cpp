// Invalid input: check reports it, and render does not ignore it.

#include "app/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace scenefile {

namespace {

using namespace testing_support;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// A valid scene with one text replaced.
std::string replaced(const std::string& what, const std::string& with) {
  std::string text = good_scene;
  return text.replace(text.find(what), what.size(), with);
}

std::string with_transform(const std::string& transform) {
  return replaced("<transblock>", "<transblock>" + transform);
}

ProgramRun check(const std::string& text) {
  return run_program({"check", "-"}, {.input = text});
}

TEST(BadInput, AMatrixWithADuplicateRowIsReported) {
  const std::string row = R"(<row a="1" b="2" c="0" d="0"/>)";
  const std::string third = R"(<row a="0" b="0" c="1" d="0"/>)";
  const std::string last = R"(<row a="0" b="0" c="0" d="1"/>)";
  const ProgramRun twice =
      check(with_transform("<matrix>" + row + row + third + last + "</matrix>"));
  EXPECT_EQ(twice.status, 0);
  EXPECT_THAT(twice.out, HasSubstr("warning: matrix with its rows 1 and 2 the same leaves no "
                                   "volume; objects inside it are not drawn [transform.flat]"));
  const ProgramRun no_last =
      check(with_transform("<matrix>" + row + last + third + third + "</matrix>"));
  EXPECT_THAT(no_last.out, HasSubstr("the last row of the matrix is 0 0 1 0; it repeats the third "
                                     "row."));
  const ProgramRun five =
      check(with_transform("<matrix>" + row + row + third + third + last + "</matrix>"));
  EXPECT_EQ(five.status, 1);
  EXPECT_THAT(five.out, HasSubstr("is one row too many: a matrix has four [xml.matrix-rows]"));
}

TEST(BadInput, AnImpossibleAspectRatioIsAWarningOfRenderToo) {
  const auto scene = [](const std::string& value) {
    return replaced("</cameradata>", "<aspectratio v=\"" + value + "\"/></cameradata>");
  };
  for (const std::string value : {"0", "-1.5", "wide"}) {
    const ProgramRun run = run_program({"render", "-", "-o", "-", "--size", "8x8"},
                                       {.input = scene(value), .out_file = "/dev/null"});
    EXPECT_EQ(run.status, 0);
    EXPECT_THAT(run.err, HasSubstr("warning: <aspectratio> \"" + value +
                                   "\" is not a ratio, and has no effect"));
  }
  EXPECT_EQ(check(scene("1.5")).status, 0);
  EXPECT_THAT(check(scene("1.5")).out,
              AllOf(HasSubstr("note: <aspectratio> has no effect"), HasSubstr("<stdin>: fine\n")));
}

TEST(BadInput, APrimitiveWithAnEmptyNameIsAnError) {
  for (const std::string name : {"", "  "}) {
    const ProgramRun run = check(replaced("\"sphere\"", "\"" + name + "\""));
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(
        run.out,
        AllOf(HasSubstr("the attribute name of the primitive is empty; it must say the "
                        "shape: cube, cone, cylinder, sphere, mesh [xml.missing-attribute]"),
              HasSubstr("<stdin>:14:")));
  }
  EXPECT_THAT(check(replaced("\"sphere\"", "\"torus\"")).out, HasSubstr("[xml.unknown-shape]"));
}

TEST(BadInput, AnIorOfZeroIsReported) {
  const std::string glass = R"(<transparent r="1" g="1" b="1"/>)";
  const ProgramRun zero = check(scene_with(glass + R"(<ior v="0"/>)"));
  EXPECT_EQ(zero.status, 0);
  EXPECT_THAT(zero.out, HasSubstr("ior 0 of the transparent sphere counts as 1"));
  EXPECT_THAT(zero.out, HasSubstr("[material.ior-unusual]"));
  const std::string none = "[material.ior-unusual]";
  EXPECT_THAT(check(scene_with(glass)).out, Not(HasSubstr(none)));
  EXPECT_THAT(check(scene_with(R"(<diffuse r="1" g="1" b="1"/><ior v="0"/>)")).out,
              Not(HasSubstr(none)));
  const std::string json = R"({"globalData": {"ambientCoeff": 1, "diffuseCoeff": 1,
    "specularCoeff": 1, "transparentCoeff": 1}, "groups": [{"primitives": [
    {"type": "sphere", "transparent": [1, 1, 1], "ior": 0}]}]})";
  EXPECT_THAT(check(json).out, HasSubstr("ior 0 of the transparent sphere counts as 1"));
}

TEST(BadInput, ARotationWithoutAxisOrAngleIsReported) {
  const ProgramRun axis = check(with_transform(R"(<rotate angle="45"/>)"));
  EXPECT_THAT(axis.out, HasSubstr("<rotate> has no axis, so it has no effect; write its axis as x, "
                                  "y and z [xml.rotate-axis]"));
  const ProgramRun angle = check(with_transform(R"(<rotate x="1" y="0" z="0"/>)"));
  EXPECT_THAT(angle.out, HasSubstr("<rotate> has no angle, so it has no effect; write its degrees "
                                   "as angle [xml.rotate-angle]"));
}

TEST(BadInput, AMisspelledFileAttributeIsUsedOrAnError) {
  const ProgramRun mesh = check(replaced("\"sphere\"", R"("mesh" filname="no.obj")"));
  EXPECT_THAT(mesh.out, HasSubstr("mesh \"no.obj\": no such file"));
  const ProgramRun two = check(replaced("\"sphere\"", R"("mesh" filname="no.obj" tag="1")"));
  EXPECT_EQ(two.status, 1);
  EXPECT_THAT(two.out, HasSubstr("unknown attribute filname of <object>; did you mean filename?"));
  const ProgramRun texture =
      check(scene_with(R"(<blend v="1"/><texture filname="no.png" u="1" v="1"/>)"));
  EXPECT_THAT(texture.out, HasSubstr("texture \"no.png\": no such file"));
}

TEST(BadInput, AMissingFileIsAShortLineAndAListOfPlaces) {
  const ProgramRun run = check(replaced("\"sphere\"", R"("mesh" filename="mesh/no.obj")"));
  EXPECT_THAT(run.out,
              HasSubstr("mesh \"mesh/no.obj\": no such file [mesh.missing]\n"
                        "    there is no folder to search; give one with --asset-root DIR\n"
                        "    files elsewhere need --asset-root DIR or --allow-outside\n"));
}

TEST(BadInput, MisorderedArguments) {
  const auto told = [](const std::vector<std::string>& words) {
    const ProgramRun run = run_program(words);
    EXPECT_EQ(run.status, 2);
    return run.err;
  };
  EXPECT_THAT(told({"a/b.xml"}), HasSubstr("a command comes first: scenefile check a/b.xml"));
  EXPECT_THAT(told({"--json", "check", "b.xml"}),
              HasSubstr("the command comes first, then options"));
  EXPECT_THAT(told({"render", "a.xml", "b.png"}), HasSubstr("the picture to write goes after -o"));
  EXPECT_THAT(told({"diff", "a.png", "b.png", "a.xml"}),
              HasSubstr("the scene of two pictures goes after --scene"));
  EXPECT_THAT(told({"explain", "a.xml", "b.png", "--pixel", "1,1"}),
              HasSubstr("your picture goes after --mine"));
}

}  // namespace

}  // namespace scenefile
