#include "scenefile/scene/vocabulary_words.h"

#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

namespace scenefile {

namespace {

constexpr std::string_view file_text = "The image file, relative to the folder of the scene.";
constexpr std::array<std::string_view, 2> repeat_texts{
    "How often the image repeats around the shape.",
    "How often the image repeats from bottom to top."};

template <typename Use>
void for_each_row(const Use& use) {
  const auto each = [&](std::string_view block, const auto& rows) {
    for (const auto& row : rows) {
      if (!row.words.about.empty()) {
        use(block, row);
      }
    }
  };
  each("globals", global_rows);
  each("camera", camera_rows);
  each("light", light_rows);
  each("material", material_rows);
}

template <typename Owner>
std::span<const std::string_view> choices_of(const ValueRow<Owner>& row) {
  return row.kind == ValueKind::choice ? light_words : std::span<const std::string_view>();
}

// Values.

std::string default_text(std::string_view value) {
  return value.empty() ? std::string() : fmt::format(" Default {}.", value);
}

// The start value in JSON, of an image only its file.
template <typename Owner>
std::string json_of(const ValueRow<Owner>& row) {
  std::string value(row.words.start);
  if (row.kind == ValueKind::image) {
    return fmt::format("\"{}\"", value.substr(0, value.find(' ')));
  }
  if (row.kind == ValueKind::choice || row.kind == ValueKind::text) {
    return {};
  }
  std::replace(value.begin(), value.end(), ' ', ',');
  return value.find(',') == value.npos ? value : fmt::format("[{}]", value);
}

template <typename Owner>
std::vector<AttributeWord> attributes_of(const ValueRow<Owner>& row) {
  const std::string_view parts = row.words.parts;
  std::vector<AttributeWord> words;
  switch (row.kind) {
    case ValueKind::vector:
      return {{"x", "The x part."}, {"y", "The y part."}, {"z", "The z part."}};
    case ValueKind::color:
      return {{"r", fmt::format("Red: {}", parts)},
              {"g", fmt::format("Green: {}", parts)},
              {"b", fmt::format("Blue: {}", parts)},
              {"a", "Has no effect: colors have three parts.", {}, false}};
    case ValueKind::coefficients:
      for (const std::string_view names : {"v1v2v3", "x y z ", "a b c "}) {
        constexpr std::array<std::string_view, 3> which{"constant", "linear", "quadratic"};
        for (std::size_t i = 0; i < which.size(); ++i) {
          const std::string_view name = names.substr(2 * i, names[2 * i + 1] == ' ' ? 1 : 2);
          words.push_back({name, fmt::format("The {} coefficient.", which[i]), {}, name[0] == 'v'});
        }
      }
      return words;
    case ValueKind::image:
      return {{"file", std::string(file_text)},
              {"u", std::string(repeat_texts[0]) + default_text("1"), {}, false},
              {"v", std::string(repeat_texts[1]) + default_text("1"), {}, false}};
    case ValueKind::number:
      return {{"v", std::string(parts), {}, row.has_member()}};
    case ValueKind::id:
    case ValueKind::choice:
    case ValueKind::text:
    case ValueKind::file:
    case ValueKind::rotation:
    case ValueKind::matrix:
      break;
  }
  return {{"v", std::string(parts), choices_of(row)}};
}

template <typename Owner>
ElementWord element_of(const ValueRow<Owner>& row) {
  const bool assumed = row.has_default(true);
  return {
      row.xml,
      std::string(row.words.about) + default_text(assumed ? row.words.start : std::string_view()),
      {},
      attributes_of(row)};
}

template <typename Owner>
void add_keys(std::vector<KeyWord>& keys, const ValueRow<Owner>& row) {
  const ValueWords& words = row.words;
  const std::string example = json_of(row);
  const std::string_view parts = row.kind == ValueKind::image ? file_text : words.parts;
  keys.push_back({row.json,
                  words.title,
                  fmt::format("{}{}{}{}{}", words.about, parts.empty() ? "" : " ",
                              row.kind == ValueKind::color ? "Red, green, blue: " : "", parts,
                              default_text(row.has_default(false) ? example : std::string())),
                  {},
                  example,
                  choices_of(row)});
  for (std::size_t i = 0; i < row.json_repeat.size() && row.kind == ValueKind::image; ++i) {
    keys.push_back({row.json_repeat[i].key,
                    row.json_repeat[i].title,
                    std::string(repeat_texts[i]) + default_text("1"),
                    {},
                    "1"});
  }
}

std::vector<KeyWord> keys_in(std::string_view wanted, std::vector<KeyWord> keys = {}) {
  for_each_row([&](std::string_view block, const auto& row) {
    if (block == wanted && !row.json.empty()) {
      add_keys(keys, row);
    }
  });
  return keys;
}

// The rest of the format.

constexpr std::string_view object_types[] = {"tree", "master", "primitive"};
constexpr std::string_view row_words[] = {"row", "row0", "row1", "row2", "row3"};
constexpr std::string_view object_names[] = {"cube", "cone", "cylinder", "sphere", "mesh", "root"};

std::vector<ElementWord> all_elements() {
  std::vector<ElementWord> words;
  const auto add_block = [&](std::string_view wanted, ElementWord element) {
    std::vector<ElementWord> values;
    for_each_row([&](std::string_view block, const auto& row) {
      if (block == wanted && !row.xml.empty()) {
        element.children.push_back(row.xml);
        values.push_back(element_of(row));
      }
    });
    words.push_back(std::move(element));
    words.insert(words.end(), values.begin(), values.end());
  };
  words.push_back(
      {"scenefile",
       "A scene: data about the picture as a whole, one camera, any number of lights, and trees of "
       "objects, of which the one named root is drawn.",
       {"globaldata", "cameradata", "lightdata", "object"}});
  add_block(
      "globals",
      {"globaldata",
       "Coefficients that scale the terms of the lighting equation in the whole scene. Optional, "
       "as is each coefficient."});
  add_block("camera",
            {"cameradata",
             "The camera, at most one. Without it a camera at 5 5 5 looks along -1 -1 -1."});
  add_block(
      "light",
      {"lightdata",
       "A light. Its type (default: point) determines what else it needs. point: position. "
       "directional: direction. spot: position, direction, angle and penumbra. area: position, "
       "direction, width and height."});
  add_block(
      "material",
      {"object",
       "A tree at the top of the file. The one named root is what is drawn and comes last; the "
       "others are masters, drawn where an object of type master uses them by name.",
       {"transblock"},
       {{"type", "At the top of the file all objects are trees.", object_types},
        {"name",
         "The name that instances use; unique among masters. Declare the master before its first "
         "use.",
         object_names},
        {"filename", "The OBJ file, relative to the folder of the scene.", {}, false},
        {"meshfile",
         "The OBJ file, relative to the folder of the scene; another name of filename.",
         {},
         false}}});
  words.insert(
      words.end(),
      {
          {"transblock",
           "One object and how it is placed: any number of transformations, then exactly one "
           "object, "
           "then nothing. The last transformation acts first.",
           {"translate", "rotate", "scale", "matrix", "object"}},
          {"translate",
           "Moves.",
           {},
           {{"x", "How far along x."}, {"y", "How far along y."}, {"z", "How far along z."}}},
          {"rotate",
           "Rotates about an axis through the origin, counterclockwise if the axis points at you.",
           {},
           {{"x", "x of the axis. Its length does not matter, but not all three are 0."},
            {"y", "y of the axis. Its length does not matter, but not all three are 0."},
            {"z", "z of the axis. Its length does not matter, but not all three are 0."},
            {"angle", "Degrees."}}},
          {"scale",
           "Scales about the origin. Negative factors mirror.",
           {},
           {{"x", "The factor along x, not 0."},
            {"y", "The factor along y, not 0."},
            {"z", "The factor along z, not 0."}}},
          {"matrix",
           "A 4x4 matrix, four rows from top to bottom. A translation is the last column; the last "
           "row "
           "is 0 0 0 1.",
           {std::begin(row_words), std::end(row_words)}},
      });
  for (const std::string_view row : row_words) {
    words.push_back({row,
                     "A row of the matrix. Its numbers are named a b c d or v1 v2 v3 v4.",
                     {},
                     {{"a", "Column 1."},
                      {"b", "Column 2."},
                      {"c", "Column 3."},
                      {"d", "Column 4: the translation."},
                      {"v1", "Column 1.", {}, false},
                      {"v2", "Column 2.", {}, false},
                      {"v3", "Column 3.", {}, false},
                      {"v4", "Column 4: the translation.", {}, false}}});
  }
  return words;
}

std::vector<ObjectWord> all_objects() {
  const std::vector<KeyWord> group{
      {"name",
       "Name",
       "A name for readers of the file. If a template group has the same name, the group is an "
       "instance of it, and must contain nothing else: to place an instance, put it into a group "
       "with the transforms.",
       {},
       "\"chair\""},
      {"translate",
       "Translation",
       "Moves the group by x, y, z. Acts after scale and rotate, whatever the order of the keys.",
       {},
       "[0,1,0]"},
      {"rotate",
       "Rotation",
       "Rotates the group: x, y, z of the axis, which is not 0 0 0, then degrees, counterclockwise "
       "if the axis points at you. Acts after scale and before translate.",
       {},
       "[0,1,0,90]"},
      {"scale",
       "Scale",
       "Scales the group along x, y, z by factors other than 0; negative ones mirror. Acts before "
       "rotate and translate.",
       {},
       "[1,1,1]"},
      {"matrix",
       "Matrix",
       "A 4x4 matrix, row by row. A translation is the last column; the last row is 0 0 0 1. Acts "
       "before scale, rotate and translate; some programs do not accept it next to other "
       "transforms.",
       {},
       "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]"},
      {"lights", "Lights",
       "Lights at the origin of the group; its transforms move and rotate them.", "light", "[]"},
      {"primitives", "Primitives",
       "Shapes about the origin of the group; its transforms place them.", "primitive", "[]"},
      {"groups", "Groups",
       "Groups in this group; their own transforms act first, then those of this group.", "group",
       "[]"},
  };
  return {
      {"",
       {
           {"name", "Name", "The name of the scene. It has no effect.", {}, "\"my scene\""},
           {"globalData", "Globals",
            "Coefficients that scale the terms of the lighting equation in the whole scene.",
            "globalData", "{}"},
           {"cameraData", "Camera", "The position and direction of the camera.", "cameraData",
            "{}"},
           {"templateGroups", "Templates",
            "Groups that are drawn wherever a group has their name. A template can use the "
            "templates before it.",
            "templateGroup", "[]"},
           {"groups", "Groups", "Everything that is drawn, and all lights.", "group", "[]"},
       }},
      {"globalData", keys_in("globals")},
      {"cameraData", keys_in("camera")},
      {"group", group},
      {"templateGroup", group},
      {"light", keys_in("light")},
      {"primitive",
       keys_in(
           "material",
           {
               {"type",
                "Shape",
                "cube, cone (its tip at y = 0.5), cylinder, sphere, or mesh, which needs meshFile.",
                {},
                {},
                shape_words},
               {"meshFile",
                "Mesh file",
                "The OBJ file of a mesh, relative to the folder of the scene.",
                {},
                "\"meshes/teapot.obj\""},
           })}};
}

std::vector<ValueWord> all_values() {
  std::vector<ValueWord> values;
  for_each_row([&](std::string_view block, const auto& row) {
    ValueWord& value =
        values.emplace_back(ValueWord{block, row.xml, row.json, row.kind, row.range});
    value.required_in_xml = is_needed(row.need, true);
    value.required_in_json = is_needed(row.need, false) && row.used_by == every_light;
    for (const RepeatKey& repeat : row.json_repeat) {
      if (!repeat.key.empty()) {
        value.repeats.push_back(repeat.key);
      }
    }
    value.assumed_in_xml = row.xml_assumed;
    value.fallback = row.has_default(false) ? json_of(row) : std::string();
    if constexpr (std::is_same_v<decltype(row), const ValueRow<Light>&>) {
      for (std::size_t i = 0; i < light_words.size() && row.used_by != every_light; ++i) {
        const auto type = static_cast<LightType>(i);
        if (row.used_by_type(type)) {
          value.used_by.push_back(light_words[i]);
        }
        if (light_needs(type, row, false)) {
          value.needed_by.push_back(light_words[i]);
        }
      }
    }
  });
  return values;
}

template <typename T>
const T* find_word(std::span<const T> words, std::string_view name) {
  const auto found =
      std::find_if(words.begin(), words.end(), [&](const T& word) { return word.name == name; });
  return found == words.end() ? nullptr : &*found;
}

}  // namespace

std::span<const ElementWord> element_words() {
  static const std::vector<ElementWord> words = all_elements();
  return words;
}

std::span<const ObjectWord> object_words() {
  static const std::vector<ObjectWord> words = all_objects();
  return words;
}

std::span<const ValueWord> value_words() {
  static const std::vector<ValueWord> words = all_values();
  return words;
}

const ElementWord* find_element(std::string_view name) {
  return find_word(element_words(), name);
}

const AttributeWord* find_attribute(const ElementWord& element, std::string_view name) {
  return find_word(std::span(element.attributes), name);
}

const ObjectWord* find_object(std::string_view name) {
  return find_word(object_words(), name);
}

const KeyWord* find_key(const ObjectWord& object, std::string_view name) {
  return find_word(std::span(object.keys), name);
}

}  // namespace scenefile
