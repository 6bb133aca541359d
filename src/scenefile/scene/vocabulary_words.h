#pragma once
// The words of the format for people who write scenes: what each means, what belongs in it, and an
// example. For completion and explanations in editors; the readers use vocabulary.h. The schemas
// have the same texts (tests/schema/words.py).

#include <span>
#include <string_view>

namespace scenefile {

/// An attribute of an XML element.
struct AttributeWord {
  std::string_view name;
  std::string_view about;                    ///< sentences; may be empty
  std::span<const std::string_view> values;  ///< if only some words are possible, or usual
  bool required = false;                     ///< by every element of that name
};

struct ElementWord {
  std::string_view name;
  std::string_view about;
  std::span<const std::string_view> children;
  std::span<const AttributeWord> attributes;
};

/// A key of a JSON object.
struct KeyWord {
  std::string_view name;
  std::string_view about;
  std::span<const std::string_view> values;
  std::string_view object;   ///< the ObjectWord of the value, or of its elements; empty: none
  std::string_view example;  ///< JSON; may be empty
};

struct ObjectWord {
  std::string_view name;  ///< empty: the scene
  std::span<const KeyWord> keys;
};

std::span<const ElementWord> element_words();
std::span<const ObjectWord> object_words();

/// The words of that name, or null.
const ElementWord* find_element(std::string_view name);
const AttributeWord* find_attribute(const ElementWord& element, std::string_view name);
const ObjectWord* find_object(std::string_view name);
const KeyWord* find_key(const ObjectWord& object, std::string_view name);

}  // namespace scenefile
