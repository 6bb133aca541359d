#include "scenefile/edit/document.h"

#include "scenefile/edit/field_words.h"
#include "scenefile/scene/vocabulary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace scenefile {

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Document opened(const std::string& text, bool compat = false) {
  ReadOptions options;
  options.compat_course = compat;
  Result<Document> document = Document::open(text, options);
  EXPECT_TRUE(document) << error_text(document);
  return document ? *document : *Document::open("<scenefile/>", options);
}

std::string kind_word(ItemKind kind) {
  constexpr const char* words[] = {"globals", "camera",    "light",    "root",  "template",
                                   "group",   "primitive", "instance", "unread"};
  return words[static_cast<int>(kind)];
}

// The items that the file contains: kind, name and first word.
std::vector<std::string> items_of(const Document& document) {
  std::vector<std::string> items;
  for (const SceneItem& item : document.items()) {
    if (item.written) {
      items.push_back(kind_word(item.kind) + (item.name.empty() ? "" : " " + item.name));
    }
  }
  return items;
}

const FieldView* field_in(const std::vector<FieldView>& fields, std::string_view name) {
  const auto found = std::find_if(fields.begin(), fields.end(),
                                  [&](const FieldView& field) { return field.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

std::string tree(const std::string& contents) {
  return "<scenefile><object type=\"tree\" name=\"root\">" + contents + "</object></scenefile>";
}

// What the reader sees, even where it is surprising.

TEST(Document, AnObjectWithoutTransblockIsAnItem) {
  const Document document = opened(tree("<object type=\"primitive\" name=\"cube\"/>"));
  EXPECT_THAT(items_of(document), ElementsAre("root", "primitive cube"));
  EXPECT_EQ(document[3].range.from, document.text().find("<object type=\"primitive\""));
}

TEST(Document, OnlyTheFirstObjectOfATransblockCounts) {
  const std::string text = tree(
      "<transblock><object type=\"primitive\" name=\"cube\"/>"
      "<object type=\"primitive\" name=\"cone\"/><translate x=\"1\" y=\"0\" z=\"0\"/>"
      "</transblock>");
  EXPECT_THAT(items_of(opened(text)), ElementsAre("root", "primitive cube"));
  EXPECT_EQ(field_in(opened(text).fields(3), "translate"), nullptr) << "it has no effect";
  const Document all = opened(text, true);
  EXPECT_THAT(items_of(all), ElementsAre("root", "primitive cube", "primitive cone"));
  EXPECT_TRUE(all[3].shared);
  EXPECT_NE(field_in(all.fields(3), "translate"), nullptr);
}

TEST(Document, SeveralGlobalDataAddUp) {
  const Document document = opened(
      "<scenefile><globaldata><ambientcoeff v=\"1\"/><diffusecoeff v=\"2\"/></globaldata>"
      "<globaldata><diffusecoeff v=\"3\"/></globaldata></scenefile>");
  const std::vector<FieldView> fields = document.fields(0);
  EXPECT_EQ(field_in(fields, "ambientcoeff")->parts[0].value, "1");
  EXPECT_EQ(field_in(fields, "diffusecoeff")->parts[0].value, "3");
  EXPECT_FALSE(field_in(fields, "specularcoeff")->written);
  EXPECT_EQ(field_in(fields, "specularcoeff")->parts[0].value, "0.5");
}

TEST(Document, AGroupNamedLikeALaterTemplateIsAGroup) {
  const Document document = opened(R"({"globalData": {}, "cameraData": {}, "templateGroups": [
        {"name": "first", "groups": [{"name": "later", "primitives": [{"type": "cube"}]}]},
        {"name": "later", "primitives": [{"type": "cone"}]}],
        "groups": [{"name": "later"}]})");
  EXPECT_THAT(items_of(document),
              ElementsAre("globals", "camera", "template first", "group later", "primitive cube",
                          "template later", "primitive cone", "root", "instance later"));
}

TEST(Document, ATreeWhoseNameIsTakenIsNotAnItem) {
  const Document document = opened(
      "<scenefile><object type=\"tree\" name=\"a\"/><object type=\"tree\" name=\"a\"/>"
      "<object type=\"tree\" name=\"root\"/></scenefile>");
  EXPECT_THAT(items_of(document), ElementsAre("template a", "root"));
}

TEST(Document, ErrorsOtherThanSyntaxDoNotMatter) {
  const Document document =
      opened(tree("<transblock><object type=\"primitive\" name=\"teapot\"/></transblock>"
                  "<transblock><object type=\"primitive\" name=\"cubee\">"
                  "<difuse r=\"1\" g=\"0\" b=\"x\"/></object></transblock><transblock/>"));
  EXPECT_THAT(items_of(document), ElementsAre("root", "unread teapot", "primitive cube", "unread"));
  const std::vector<FieldView> fields = document.fields(4);
  EXPECT_EQ(field_in(fields, "diffuse")->parts[2].value, "x") << "the reader takes <difuse> for it";
  EXPECT_TRUE(document.findings().has_errors());
}

TEST(Document, SyntaxErrorsAreRefused) {
  EXPECT_THAT(error_text(Document::open("<scenefile>\n<globaldata>", {})), HasSubstr("line"));
  EXPECT_THAT(error_text(Document::open("{\"globalData\": {,}}", {})), HasSubstr("line 1"));
  EXPECT_THAT(error_text(Document::open("<other/>", {})), HasSubstr("not a scene"));
  EXPECT_THAT(error_text(Document::open("", {})), ::testing::Not(""));
  const ReadOptions compat{.compat_course = true, .limits = {}};
  EXPECT_FALSE(Document::open("{\"cameraData\": {\"heightAngle\": .5}}", compat));
}

// Fields and places.

TEST(Document, FieldsSayWhatIsWrittenAndWhere) {
  const std::string text =
      "\xEF\xBB\xBF<scenefile><lightdata><id v='3'/><type v=\"spot\"/>"
      "<function a=\"1\" b=\"0.10\" c=\"0\"/><angle value=\" 30\"/></lightdata></scenefile>";
  const Document document = opened(text);
  const std::vector<FieldView> fields = document.fields(2);
  const FieldView& falloff = *field_in(fields, "function");
  EXPECT_EQ(falloff.title, "Attenuation");
  EXPECT_EQ(falloff.kind, ValueKind::coefficients);
  EXPECT_EQ(falloff.parts[1].value, "0.10");
  EXPECT_EQ(text.substr(falloff.parts[1].place.from, falloff.parts[1].place.size()), "0.10");
  EXPECT_EQ(text.substr(falloff.place.from, falloff.place.size()),
            "<function a=\"1\" b=\"0.10\" c=\"0\"/>");
  EXPECT_EQ(field_in(fields, "angle")->parts[0].value, " 30");
  EXPECT_TRUE(field_in(fields, "penumbra")->needed);
  EXPECT_FALSE(field_in(fields, "penumbra")->written);
  EXPECT_EQ(field_in(fields, "width"), nullptr) << "a spot light has none";
  EXPECT_THAT(field_in(fields, "type")->choices,
              ElementsAre("point", "directional", "spot", "area"));
}

TEST(Document, EscapesAndEncodings) {
  const std::string text =
      "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?><!-- \xE9\xE9 --><scenefile>"
      "<object type=\"tree\" name=\"caf\xE9 &amp; &#233;\"/><object type=\"tree\" name=\"root\"/>"
      "</scenefile>";
  const Document document = opened(text);
  EXPECT_THAT(items_of(document), ElementsAre("template caf\xC3\xA9 & \xC3\xA9", "root"));
  EXPECT_EQ(document.fields(2)[0].parts[0].value, "caf\xC3\xA9 & \xC3\xA9");
  const Document json = opened(R"({"groups": [{"n\u0061me": "a\"\u00e9", "primitives": []}]})");
  EXPECT_EQ(json[3].name, "a\"\xC3\xA9");
}

TEST(Document, FindsItemsByPlace) {
  const std::string text =
      "<scenefile>\n<object type=\"tree\" name=\"root\">\n<transblock>\n<translate x=\"1\" y=\"0\" "
      "z=\"0\"/>\n<object type=\"primitive\" name=\"cube\"/>\n</transblock>\n</object>\n"
      "</scenefile>\n";
  const Document document = opened(text);
  const Node& node = document.scene().nodes[document[3].node];
  EXPECT_EQ(document.item_of(node.transforms[0].location), std::optional<ItemId>(3));
  EXPECT_EQ(document.item_of(node.primitives[0].location), std::optional<ItemId>(3));
  EXPECT_EQ(document.item_of({1, 1}), std::nullopt);
  EXPECT_EQ(document.item_at(static_cast<std::uint32_t>(text.find("cube"))),
            std::optional<ItemId>(3));
}

TEST(Document, CommentsBelongToWhatTheyAreNextTo) {
  const std::string text =
      "<scenefile>\n  <!-- above\n       still -->\n  <lightdata/> <!-- beside -->\n"
      "</scenefile>\n";
  const Document document = opened(text);
  const TextRange range = document.with_comments(2);
  EXPECT_EQ(text.substr(range.from, range.size()),
            "<!-- above\n       still -->\n  <lightdata/> <!-- beside -->");
}

// A value that the vocabulary has, but the table of fields lacks, could not be edited.
template <typename Owner, std::size_t N>
void expect_words(const ValueRow<Owner> (&rows)[N], ItemKind kind) {
  for (const ValueRow<Owner>& row : rows) {
    for (const bool xml : {true, false}) {
      const std::string_view name = xml ? row.xml : row.json;
      const auto words = ordered_words(kind, xml);
      const bool known = std::any_of(words.begin(), words.end(), [&](const FieldWord* word) {
        return word->name(xml) == name;
      });
      EXPECT_TRUE(name.empty() || !row.has_member() || known) << name;
    }
  }
}

TEST(Document, EveryValueOfTheVocabularyIsAField) {
  expect_words(global_rows, ItemKind::globals);
  expect_words(camera_rows, ItemKind::camera);
  expect_words(light_rows, ItemKind::light);
  expect_words(material_rows, ItemKind::primitive);
}

TEST(Document, TypedValues) {
  FieldView field;
  field.title = "Height angle";
  FieldPart& angle = field.parts.emplace_back();
  angle.name = "heightangle";
  angle.range = {0, 180, true, true};
  EXPECT_EQ(*parse_value(field, 0, " 0.50 "), "0.50");
  EXPECT_EQ(*parse_value(field, 0, ".5"), "0.5") << "JSON has no .5";
  EXPECT_EQ(*parse_value(field, 0, "+45."), "45");
  EXPECT_EQ(error_text(parse_value(field, 0, "wide")),
            "Height angle: \"wide\" is not a number; write one like 1.5 or -2e3");
  EXPECT_EQ(error_text(parse_value(field, 0, "180")),
            "Height angle: 180 is out of range: it must be more than 0 and less than 180");
  EXPECT_THAT(error_text(parse_value(field, 0, "")), HasSubstr("enter a number"));
  EXPECT_THAT(error_text(parse_value(field, 0, "1e99")), HasSubstr("too large"));
}

}  // namespace

}  // namespace scenefile
