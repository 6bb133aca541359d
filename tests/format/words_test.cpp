// The readers know every word that editors and the schemas explain.

#include "format/reading.h"
#include "scenefile/scene/vocabulary.h"
#include "scenefile/scene/vocabulary_words.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>
#include <string_view>

namespace scenefile::testing {
namespace {

bool calls_a_word_unknown(std::string_view code) {
  for (const std::string_view end :
       {".unknown-element", ".misspelled-element", ".misplaced-element", ".unknown-attribute",
        ".misspelled-attribute", ".unknown-key", ".misspelled-key"}) {
    if (code.ends_with(end)) {
      return true;
    }
  }
  return false;
}

void expect_known(const std::string& text) {
  const Reading reading = read(text);
  for (const Diagnostic& d : reading.diagnostics.list()) {
    EXPECT_FALSE(calls_a_word_unknown(d.code->name)) << text << "\n" << d.message;
  }
}

std::string with_attributes(std::string_view name, std::string_view attributes,
                            std::string_view inside) {
  return inside.empty() ? fmt::format("<{}{}/>", name, attributes)
                        : fmt::format("<{0}{1}>{2}</{0}>", name, attributes, inside);
}

// The element in those that contain it. An object with a transblock is a tree.
std::string in_scene(std::string_view parent, const std::string& element) {
  if (parent == "scenefile") {
    return fmt::format("<scenefile>{}</scenefile>", element);
  }
  if (parent == "matrix") {
    return with_transforms(with_attributes(parent, "", element));
  }
  if (parent == "transblock") {
    return in_root(with_attributes(parent, "", element));
  }
  if (parent == "object") {
    return element.starts_with("<transblock") ? in_root(element) : with_material(element);
  }
  return with_top(with_attributes(parent, "", element));
}

TEST(Words, OfXmlAreKnownToTheReader) {
  std::size_t count = 0;
  for (const ElementWord& parent : element_words()) {
    for (const std::string_view name : parent.children) {
      const ElementWord* const element = find_element(name);
      ASSERT_NE(element, nullptr) << name;
      expect_known(in_scene(parent.name, with_attributes(name, "", "")));
      for (const AttributeWord& attribute : element->attributes) {
        const std::string alone = fmt::format(" {}=\"1\"", attribute.name);
        expect_known(in_scene(parent.name, with_attributes(name, alone, "")));
        ++count;
      }
    }
  }
  EXPECT_GT(count, 60u);
}

TEST(Words, OfJsonAreKnownToTheReader) {
  const std::map<std::string_view, std::string> before{
      {"", R"({"globalData": {}, )"},
      {"globalData", "{\"globalData\": {"},
      {"cameraData", "{\"cameraData\": {"},
      {"group", "{\"globalData\": {}, \"groups\": [{"},
      {"templateGroup", "{\"globalData\": {}, \"templateGroups\": [{"},
      {"light", "{\"globalData\": {}, \"groups\": [{\"lights\": [{"},
      {"primitive", "{\"globalData\": {}, \"groups\": [{\"primitives\": [{"}};
  for (const ObjectWord& object : object_words()) {
    ASSERT_TRUE(before.contains(object.name)) << object.name;
    for (const KeyWord& key : object.keys) {
      std::string text = fmt::format("{}\"{}\": 1", before.at(object.name), key.name);
      std::string ends;
      for (const char c : before.at(object.name)) {
        c == '}' ? ends.erase(0, 1) : ends.insert(0, c == '{' ? "}" : c == '[' ? "]" : "");
      }
      expect_known(text + ends);
    }
  }
}

// The element that gives a value the numbers.
std::string element_with(std::string_view name, std::string_view numbers) {
  std::istringstream stream{std::string(numbers)};
  std::string attributes;
  std::string number;
  for (const AttributeWord& attribute : find_element(name)->attributes) {
    if (stream >> number) {
      attributes += fmt::format(" {}=\"{}\"", attribute.name, number);
    }
  }
  return with_attributes(name, attributes, "");
}

template <typename Rows>
std::string elements_assumed(const Rows& rows) {
  std::string elements;
  for (const auto& row : rows) {
    elements += row.xml_assumed.empty() ? "" : element_with(row.xml, row.xml_assumed);
  }
  return elements;
}

TEST(Words, AssumedValuesAreWhatTheReaderAssumes) {
  const auto scene_with = [](const std::string& camera, const std::string& light) {
    return with_top(fmt::format(
        R"(<cameradata>{}</cameradata>
<lightdata><id v="0"/><type v="spot"/><direction x="0" y="-1" z="0"/><angle v="30"/>{}</lightdata>)",
        camera, light));
  };
  const std::string camera = elements_assumed(camera_rows);
  const std::string light = elements_assumed(light_rows);
  const Reading assumed = read(scene_with("", ""));
  const Reading written = read(scene_with(camera, light));
  EXPECT_EQ(assumed.diagnostics.list().size(), 7u);
  EXPECT_EQ(written.diagnostics.list().size(), 0u) << camera << light;
  EXPECT_TRUE(assumed.scene == written.scene) << camera << light;
}

}  // namespace
}  // namespace scenefile::testing
