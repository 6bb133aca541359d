#include "scenefile/lsp/outline.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

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

// What refers to a template, as the reader understands it: "declaration>", "use", with places.
std::string names_of(const std::string& text) {
  std::string names;
  for (const NameUse& use : read_outline(text).names) {
    names += fmt::format("{}{}@{} ", use.declares ? ">" : "", use.name, use.from);
  }
  return names;
}

TEST(LspOutline, TreesInsideTreesMayBeInstancesOrTemplates) {
  const auto scene = [](const std::string& top, const std::string& inside) {
    return "<scenefile>" + top + "<object type='tree' name='root'>" + inside +
           "</object></scenefile>";
  };
  const std::string a = "<object type='tree' name='a'><transblock/></object>";
  EXPECT_EQ(names_of(scene(a, "<object type='tree' name='a'/>")), ">a@37 a@120 ");
  EXPECT_EQ(names_of(scene(a, "<object type='tree' name='a'> </object>")), ">a@37 a@120 ");
  EXPECT_EQ(names_of(scene("", a + "<object type='master' name='a'/>")), ">a@69 a@122 ");
  EXPECT_EQ(names_of(scene("", a + "<object type='tree' name='b'/>")), "");
  EXPECT_EQ(read_outline(scene(a, "<object type='tree' name='b'/>")).other_names,
            std::vector<std::string>{"b"});
}

TEST(LspOutline, ReadsOtherLetterCaseLikeTheReader) {
  EXPECT_EQ(names_of("<Scenefile><Object NAME='x' Type='Tree' name='a'><transblock/></Object>"
                     "<object type='tree' name='root'><object TYPE='Master' Name='a'/></object>"),
            ">a@46 a@131 ");
}

TEST(LspOutline, NamesAreWithoutEscapes) {
  const std::string text =
      "<scenefile><object type='tree' name='a&amp;&#98;&#x;'/><object type='master' "
      "name='a&#38;b&#x;'/>";
  const Outline outline = read_outline(text);
  ASSERT_EQ(outline.names.size(), 2U);
  EXPECT_EQ(outline.names[0].name, "a&b&#x;");
  EXPECT_EQ(outline.names[1].name, "a&b&#x;");
  EXPECT_EQ(outline.parts[0].name, "a&b&#x;");
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
