#include "scenefile/lsp/completion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace scenefile {
namespace {

// `|` marks the place.
Completion complete_at(std::string text) {
  const std::size_t at = text.find('|');
  text.erase(at, 1);
  return complete(text, at);
}

// The inserted text of the item with that label; "-" if there is none.
std::string inserted(const std::string& text, std::string_view label) {
  const Completion found = complete_at(text);
  const auto item = std::find_if(found.items.begin(), found.items.end(),
                                 [&](const CompletionItem& i) { return i.label == label; });
  return item == found.items.end() ? "-" : item->text;
}

TEST(LspCompletion, Elements) {
  EXPECT_EQ(inserted("<|", "scenefile"), "scenefile></scenefile>");
  EXPECT_EQ(inserted("<scenefile><cameradata><p|", "pos"), "pos x=\"\" y=\"\" z=\"\"/>");
  EXPECT_EQ(inserted("<scenefile><cameradata><|", "/cameradata"), "/cameradata>");
  EXPECT_EQ(inserted("<scenefile><cameradata></|", "cameradata"), "cameradata>");
  EXPECT_EQ(inserted("<scenefile><cameradata><pos x='1'/><|", "up"), "up x=\"\" y=\"\" z=\"\"/>");
  EXPECT_EQ(inserted("<scenefile><cameradata></cameradata><|", "lightdata"),
            "lightdata></lightdata>");
  EXPECT_EQ(inserted("<scenefile><cameradata><|", "diffuse"), "-");
  EXPECT_EQ(inserted("<scenefile><!-- <|", "lightdata"), "-");
  EXPECT_EQ(inserted("<scenefile><lightdata <|", "color"), "-");
}

TEST(LspCompletion, AttributesAndValues) {
  EXPECT_EQ(inserted("<rotate x=\"1\" |", "angle"), "angle=\"\"");
  EXPECT_EQ(inserted("<rotate x=\"1\" |", "x"), "-");
  EXPECT_EQ(inserted("<object type=\"|", "primitive"), "primitive");
  EXPECT_EQ(inserted("<object type=\"primitive\" name=\"c|\"/>", "cube"), "cube");
  EXPECT_EQ(inserted("<object type=\"primitive\" name=\"a>b\" |", "filename"), "filename=\"\"");
  EXPECT_EQ(inserted("<mood |", "v"), "-");
}

const std::string templates =
    "<scenefile><object type=\"tree\" name=\"leg &amp; foot\"/>"
    "<object type=\"tree\" name=\"chair\"><transblock>";

TEST(LspCompletion, NamesByTheTypeOfTheObject) {
  const std::string rest = "</transblock></object></scenefile>";
  const std::string master = templates + "<object type=\"master\" name=\"|\"/>" + rest;
  EXPECT_EQ(inserted(master, "leg & foot"), "leg &amp; foot");
  EXPECT_EQ(inserted(master, "chair"), "-") << "it would contain itself";
  EXPECT_EQ(inserted(master, "cube"), "-");
  EXPECT_EQ(inserted(templates + "<object name=\"|\" type='Master'/>" + rest, "leg & foot"),
            "leg &amp; foot");
  const std::string primitive = templates + "<object type=\"primitive\" name=\"|\"/>" + rest;
  EXPECT_EQ(inserted(primitive, "cube"), "cube");
  EXPECT_EQ(inserted(primitive, "leg & foot"), "-");
  EXPECT_EQ(inserted(templates + "<object name=\"|\"/>" + rest, "leg & foot"), "leg &amp; foot");
  EXPECT_EQ(inserted("<scenefile><object type=\"tree\" name=\"|\"/>", "root"), "root");
  EXPECT_EQ(inserted("<scenefile><object type=\"tree\" name=\"|\"/>", "cube"), "-");
  EXPECT_EQ(inserted("<object type=\"master\" |/>", "filename"), "-");
}

TEST(LspCompletion, ElementsByTheTypeOfTheObject) {
  const std::string tree = "<scenefile><object type=\"tree\" name=\"root\"><|";
  EXPECT_EQ(inserted(tree, "transblock"), "transblock></transblock>");
  EXPECT_EQ(inserted(tree, "diffuse"), "-");
  const std::string primitive =
      "<scenefile><object type=\"tree\"><transblock><object name='cube' type='primitive'><|";
  EXPECT_EQ(inserted(primitive, "transblock"), "-");
  EXPECT_EQ(inserted(primitive, "diffuse"), "diffuse r=\"\" g=\"\" b=\"\"/>");
  EXPECT_EQ(inserted("<scenefile><object type=\"master\"><|", "transblock"), "-");
  EXPECT_EQ(inserted("<scenefile><object type=\"\"><|", "transblock"), "transblock></transblock>");
}

TEST(LspCompletion, TemplatesInJson) {
  const std::string before = R"({"templateGroups": [{"name": "a\"b", "groups": [{"name": "x"}]}, )"
                             R"({"name": "chair", "groups": [{"name": )";
  EXPECT_EQ(inserted(before + R"("|"}]}]})", R"("a\"b")"), R"("a\"b")");
  EXPECT_EQ(inserted(before + R"("|"}]}]})", "\"chair\""), "-") << "it would contain itself";
  EXPECT_EQ(inserted(before + R"("x"}]}], "groups": [{"name": "|"}]})", "\"chair\""), "\"chair\"");
  EXPECT_EQ(inserted(before + R"("x"}]}], "groups": [{"name": "|"}]})", "\"x\""), "-");
  EXPECT_EQ(inserted(before + R"("x"}]}, {"name": "|"}]})", "\"chair\""), "-");
}

TEST(LspCompletion, KeysAndValuesOfJson) {
  EXPECT_EQ(inserted("{|", "\"globalData\""), "\"globalData\": {}");
  EXPECT_EQ(inserted(R"({"globalData": {"am|"}})", "\"ambientCoeff\""), "\"ambientCoeff\": 0.5");
  EXPECT_EQ(inserted(R"({"globalData": {"am|": 1}})", "\"ambientCoeff\""), "\"ambientCoeff\"");
  EXPECT_EQ(inserted(R"({"groups": [{"groups": [{"primitives": [{"type": "|"}]}]}]})", "\"cone\""),
            "\"cone\"");
  EXPECT_EQ(inserted(R"({"templateGroups": [{"lights": [{"type": |}]}]})", "\"spot\""), "\"spot\"");
  EXPECT_EQ(inserted(R"({"groups": [{"lights": [{"color": [|]}]}]})", "\"color\""), "-");
  EXPECT_EQ(inserted(R"({"mood": {|}})", "\"groups\""), "-");
}

TEST(LspCompletion, ReplacesTheWordAtThePlace) {
  const Completion found = complete_at(R"({"gl|"})");
  EXPECT_EQ(found.from, 1U);
  EXPECT_EQ(found.to, 5U);
}

// The text after an item is inserted.
std::string completed(const std::string& text, std::string_view label) {
  const Completion found = complete_at(text);
  std::string after = text;
  after.erase(after.find('|'), 1);
  return inserted(text, label) == "-"
             ? "-"
             : after.replace(found.from, found.to - found.from, inserted(text, label));
}

TEST(LspCompletion, KeepsWhatFollows) {
  EXPECT_EQ(completed("<scenefile><globaldata><amb| v='1'/>", "ambientcoeff"),
            "<scenefile><globaldata><ambientcoeff v='1'/>");
  EXPECT_EQ(completed("<scenefile><globaldata><amb|ient/>", "ambientcoeff"),
            "<scenefile><globaldata><ambientcoeff/>");
  EXPECT_EQ(completed("<scenefile><cam|\n<lightdata>", "cameradata"),
            "<scenefile><cameradata></cameradata>\n<lightdata>");
  EXPECT_EQ(completed("<scenefile><cameradata></cam|era>", "cameradata"),
            "<scenefile><cameradata></cameradata>");
  EXPECT_EQ(completed("<rotate w|='1' y='2'/>", "x"), "<rotate x='1' y='2'/>");
  EXPECT_EQ(completed("<rotate |y='2'/>", "x"), "<rotate x=\"\" y='2'/>");
  EXPECT_EQ(completed("<rotate |y='2'/>", "y"), "-");
  EXPECT_EQ(completed("<object type='pri|mitive'/>", "tree"), "<object type='tree'/>");
  EXPECT_EQ(completed(R"({"globalData": {"am|bient": 1}})", "\"ambientCoeff\""),
            R"({"globalData": {"ambientCoeff": 1}})");
  EXPECT_EQ(completed(R"({"globalData": {| "diffuseCoeff": 1}})", "\"ambientCoeff\""),
            R"({"globalData": {"ambientCoeff": 0.5, "diffuseCoeff": 1}})");
}

TEST(LspCompletion, WordsHaveMeanings) {
  const std::string xml = "<scenefile><lightdata><penumbra v=\"1\"/></lightdata></scenefile>";
  const auto element = describe(xml, xml.find("umbra"));
  ASSERT_TRUE(element);
  EXPECT_EQ(xml.substr(element->from, element->to - element->from), "penumbra");
  EXPECT_TRUE(describe(xml, xml.find("v=")));
  EXPECT_FALSE(describe(xml, xml.find("1\"")));
  EXPECT_FALSE(describe("<!-- penumbra -->", 8));
  const std::string json = R"({"cameraData": {"heightAngle": 45}})";
  EXPECT_TRUE(describe(json, json.find("Angle")));
  EXPECT_FALSE(describe(json, json.find("45")));
}

// Every place of a text, and every text that begins like it, gives an answer.
TEST(LspCompletion, EveryPlaceIsSafe) {
  for (
      const std::string text :
      {"<scenefile><!-- a --><object type=\"tree\" name='x'><transblock/></object></scenefile>",
       R"({"groups": [{"name": "a\"b", "primitives": [{"type": "cube", "diffuse": [1, 0, 1]}]}]})"}) {
    for (std::size_t end = 0; end <= text.size(); ++end) {
      for (std::size_t at = 0; at <= end; ++at) {
        const std::string start = text.substr(0, end);
        const Completion found = complete(start, at);
        EXPECT_LE(found.from, found.to);
        EXPECT_LE(found.to, end);
        (void)describe(start, at);
        EXPECT_LE(word_end(start, at), end);
      }
    }
  }
}

}  // namespace
}  // namespace scenefile
