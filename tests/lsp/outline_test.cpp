#include "scenefile/lsp/outline.h"

#include <gtest/gtest.h>

#include <string>

namespace scenefile {
namespace {

const std::string xml = R"(<scenefile>
  <globaldata/><lightdata><type v="spot"/><color r="1" g="0.5" b="0"/></lightdata>
  <object type="tree" name="leg"><transblock><object type="primitive" name="cube">
    <diffuse r="2" g="0" b="0"/></object></transblock></object>
  <object type="tree" name="root"><transblock><object type="master" name="leg"/></transblock></object>
</scenefile>)";

const std::string json = R"({"globalData": {}, "templateGroups": [{"name": "leg", "primitives": [
  {"type": "cube", "diffuse": [1, 0.5, 0]}]}],
  "groups": [{"groups": [{"name": "leg"}]}, {"name": "only mine", "lights": [{"type": "spot"}]}]})";

std::string tree_of(const std::string& text) {
  std::string tree;
  for (const OutlinePart& part : read_outline(text).parts) {
    tree += std::string(part.depth, ' ') + part.name + ":" + part.detail + "\n";
    EXPECT_LT(part.from, part.to);
    EXPECT_LE(part.to, text.size());
  }
  return tree;
}

TEST(LspOutline, HasTheParts) {
  EXPECT_EQ(tree_of(xml),
            "globaldata:\nlightdata:spot\nleg:tree\n cube:primitive\nroot:tree\n leg:master\n");
  EXPECT_EQ(tree_of(json),
            "globalData:\nleg:\n primitive:cube\ngroup:\n leg:\nonly mine:\n light:spot\n");
  const OutlinePart last = read_outline(json).parts.back();
  EXPECT_EQ(json.substr(last.from, last.to - last.from), R"({"type": "spot"})");
}

TEST(LspOutline, HasTheNamesOfTemplates) {
  for (const std::string& text : {xml, json}) {
    const Outline outline = read_outline(text);
    ASSERT_EQ(outline.names.size(), 2U);
    EXPECT_TRUE(outline.names[0].declares);
    EXPECT_FALSE(outline.names[1].declares);
    for (const NameUse& use : outline.names) {
      EXPECT_EQ(text.substr(use.from, use.to - use.from), "leg");
    }
  }
}

TEST(LspOutline, HasColorsThatCanBeShown) {
  for (const std::string& text : {xml, json}) {
    const Outline outline = read_outline(text);
    ASSERT_EQ(outline.colors.size(), 1U);  // not one with a 2
    const ColorValue& color = outline.colors[0];
    const std::string written = text.substr(color.from, color.to - color.from);
    EXPECT_EQ(written, color_text({1, 0.5, 0}, &text != &json && text[0] == '<'));
    EXPECT_EQ(color.rgb[1], 0.5F);
  }
}

TEST(LspOutline, BeginningsOfTextsAreSafe) {
  for (const std::string& text : {xml, json}) {
    for (std::size_t end = 0; end <= text.size(); ++end) {
      tree_of(text.substr(0, end));
    }
  }
}

}  // namespace
}  // namespace scenefile
