// The readers know every word that editors and the schemas explain.

#include "format/reading.h"
#include "scenefile/scene/vocabulary_words.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

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

}  // namespace
}  // namespace scenefile::testing
