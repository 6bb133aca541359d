#include "scenefile/verbs/explain.h"
#include "scenefile/verbs/load_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace scenefile {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* scene_text =
    "<scenefile><cameradata><pos x='0' y='1' z='3'/><look x='0' y='-1' z='-3'/>"
    "<up x='0' y='1' z='0'/><heightangle v='1'/></cameradata><object type='tree' name='root'>"
    "<transblock><object type='primitive' name='mesh' filename='room.obj'/></transblock>"
    "</object></scenefile>";

// A floor, and above it a lamp of two triangles: one with the black half of the map, and one with
// the white one.
constexpr const char* mesh_text =
    "mtllib room.mtl\n"
    "v -9 0 9\nv 9 0 9\nv 9 0 -9\nv -9 0 -9\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1\n"
    "vt 0.25 0.5\nvt 0.75 0.5\nusemtl floor\nf 1 2 3 4\n"
    "usemtl lamp\nf 5/1 6/1 7/1\nf 5/2 7/2 8/2\n";

// Of `sample`, the first surface.
std::string explained(std::uint32_t sample) {
  const FetchFile fetch = [](const std::string& name) -> Result<std::string> {
    using namespace std::string_literals;
    if (name.ends_with(".obj")) {
      return std::string(mesh_text);
    }
    if (name.ends_with(".mtl")) {
      return "newmtl floor\nKd 0.5 0.5 0.5\nnewmtl lamp\nKe 5 5 5\nmap_Ke half.tga\n"s;
    }
    return "\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\x18\0\0\0\0\xff\xff\xff"s;
  };
  const LoadedScene scene = load_scene("room.xml", scene_text, fetch);
  RenderOptions options;
  options.mode = Mode::path;
  options.width = options.height = 1;
  options.samples = 16;
  options.max_depth = 1;
  const Result<ExplainReport> report = explain_pixel(scene, options, 0, 0, sample);
  return report ? explain_text(scene, *report) : report.error().text;
}

TEST(ExplainPath, SaysWhereLampsAreBlack) {
  int black = 0;
  for (std::uint32_t sample = 0; sample < 16; ++sample) {
    const std::string text = explained(sample);
    EXPECT_THAT(text, HasSubstr("lamp"));
    EXPECT_THAT(text, Not(HasSubstr("faces away")));
    black += text.find("the lamp is black there") != std::string::npos ? 1 : 0;
  }
  EXPECT_NEAR(black, 8, 4);
}

}  // namespace
}  // namespace scenefile
