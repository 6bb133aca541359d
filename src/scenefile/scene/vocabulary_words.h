#pragma once
// The words of the format for people who write scenes: what each means, what belongs in it, and an
// example. For completion and explanations in editors, and for the schemas. Those of values are
// made from the rows of vocabulary.h, which the readers use.

#include "scenefile/scene/value_kind.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// An attribute of an XML element.
struct AttributeWord {
  std::string_view name;
  std::string about;                           ///< sentences; may be empty
  std::span<const std::string_view> values{};  ///< if only some words are possible, or usual
  bool required = true;                        ///< by every element of that name
};

struct ElementWord {
  std::string_view name;
  std::string about;
  std::vector<std::string_view> children{};
  std::vector<AttributeWord> attributes{};
};

/// A key of a JSON object.
struct KeyWord {
  std::string_view name;
  std::string_view title;
  std::string about;
  std::string_view object{};                   ///< the ObjectWord of the value, or of its elements
  std::string example{};                       ///< JSON; may be empty
  std::span<const std::string_view> values{};  ///< if only some words are possible
};

struct ObjectWord {
  std::string_view name;  ///< empty: the scene
  std::vector<KeyWord> keys;
};

/// What the schemas need to know of a value.
struct ValueWord {
  std::string_view block;  ///< "globals", "camera", "light", "material"
  std::string_view xml;    ///< empty: not available in that dialect
  std::string_view json;
  ValueKind kind = ValueKind::number;
  NumberRange range;
  std::vector<std::string_view> repeats{};  ///< image: keys of how often it repeats
  bool required_in_xml = false;             ///< by the lights that use it
  bool required_in_json = false;            ///< the same; false if that depends on the light
  std::string_view assumed_in_xml{};        ///< with a warning if it is missing; may be empty
  std::string fallback{};  ///< JSON: what counts if it is missing; empty: that depends
  std::vector<std::string_view> needed_by{};  ///< in JSON, if that depends on the type of the light
  std::vector<std::string_view> used_by{};    ///< the types of light
};

std::span<const ElementWord> element_words();
std::span<const ObjectWord> object_words();
std::span<const ValueWord> value_words();

/// The words of that name, or null.
const ElementWord* find_element(std::string_view name);
const AttributeWord* find_attribute(const ElementWord& element, std::string_view name);
const ObjectWord* find_object(std::string_view name);
const KeyWord* find_key(const ObjectWord& object, std::string_view name);

}  // namespace scenefile
