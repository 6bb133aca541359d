// Large and deep scenes are read like small ones.

#include "format/reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace scenefile::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string repeated(std::string_view text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) {
    all += text;
  }
  return all;
}

std::string in_json(std::string_view group) {
  return fmt::format(R"({{"globalData": {{"ambientCoeff": 0.5, "diffuseCoeff": 0.5,
    "specularCoeff": 0.5}}, "cameraData": {{"position": [0, 0, 5], "up": [0, 1, 0],
    "look": [0, 0, -1], "heightAngle": 45}}, {}}})",
                     group);
}

constexpr std::string_view cube_block =
    "<transblock><object type=\"primitive\" name=\"cube\"/></transblock>";

TEST(LargeScene, ManyBlocks) {
  const Reading reading = read(in_root(repeated(cube_block, 20'000)));
  EXPECT_THAT(found(reading), IsEmpty());
  EXPECT_EQ(reading.scene.nodes.size(), 20'001u);
  EXPECT_EQ(reading.scene.nodes[reading.scene.root].children.size(), 20'000u);
}

TEST(LargeScene, PlacesInOneLongLine) {
  const std::string text = "<scenefile><object type=\"tree\" name=\"root\">" +
                           repeated(cube_block, 3000) + "<frob/></object></scenefile>";
  EXPECT_THAT(found(text),
              ElementsAre(fmt::format("1:{} warning xml.unknown-element", text.find("<frob") + 1)));
}

TEST(LargeScene, DeepGroupsNeedNoStack) {
  ReadOptions options;
  options.limits.nesting = 1'000'000;
  const int depth = 100'000;
  const std::string text =
      in_json(repeated("\"groups\": [{", depth) + "\"primitives\": [{\"type\": \"cube\"}]" +
              repeated("}]", depth));
  const Reading reading = read(text, options);
  EXPECT_THAT(found(reading), IsEmpty());
  EXPECT_EQ(reading.scene.nodes.size(), static_cast<std::size_t>(depth) + 1);
}

TEST(LargeScene, KeysAreBounded) {
  std::string keys;
  for (int i = 0; i < 300; ++i) {
    keys += fmt::format("\"k{}\": {},", i, i);
  }
  const std::vector<std::string> all =
      found(in_json("\"groups\": [{" + keys + "\"primitives\": []}]"));
  const auto ending_in = [&](std::string_view code) {
    return std::count_if(all.begin(), all.end(),
                         [&](const std::string& line) { return line.ends_with(code); });
  };
  EXPECT_EQ(ending_in("error json.limit"), 1);
  EXPECT_EQ(ending_in("warning json.unknown-key"), 100);
}

}  // namespace
}  // namespace scenefile::testing
