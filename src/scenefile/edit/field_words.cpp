#include "scenefile/edit/field_words.h"

#include "scenefile/scene/vocabulary.h"

#include <algorithm>
#include <vector>

namespace scenefile {

std::span<const FieldWord> words_of(ItemKind kind) {
  switch (kind) {
    case ItemKind::globals:
      return global_fields;
    case ItemKind::camera:
      return camera_fields;
    case ItemKind::light:
      return light_fields;
    case ItemKind::primitive:
      return primitive_fields;
    case ItemKind::root:
    case ItemKind::master:
    case ItemKind::group:
    case ItemKind::instance:
    case ItemKind::unread:
      break;
  }
  return {};
}

std::vector<const FieldWord*> ordered_words(ItemKind kind, bool xml) {
  std::vector<const FieldWord*> words;
  for (const FieldWord& word : words_of(kind)) {
    if (!word.name(xml).empty()) {
      words.push_back(&word);
    }
  }
  if (xml) {
    std::stable_sort(words.begin(), words.end(), [](const FieldWord* a, const FieldWord* b) {
      return a->xml_rank < b->xml_rank;
    });
  }
  return words;
}

LightUse light_use(std::string_view field, std::string_view type, bool xml) {
  const auto* const found = std::find(light_words.begin(), light_words.end(), type);
  const auto light = static_cast<LightType>(found - light_words.begin());
  for (const ValueRow<Light>& row : light_rows) {
    if ((xml ? row.xml : row.json) == field) {
      const bool used = row.used_by_type(light);
      const bool falloff = row.field == Field::attenuation;
      return {used && row.kind != ValueKind::text && !(falloff && (xml || !course_json_has(light))),
              used || (xml && row.idle_in_xml)};
    }
  }
  return {};
}

std::vector<std::string_view> parts_of(const FieldWord& word, bool xml) {
  switch (word.kind) {
    case FieldKind::vector:
      return {"x", "y", "z"};
    case FieldKind::color:
      return {"r", "g", "b"};
    case FieldKind::coefficients:
      return xml ? std::vector<std::string_view>{"v1", "v2", "v3"}
                 : std::vector<std::string_view>{"constant", "linear", "quadratic"};
    case FieldKind::rotation:
      return {"x", "y", "z", "angle"};
    case FieldKind::matrix:
      return {"a", "b", "c", "d", "a", "b", "c", "d", "a", "b", "c", "d", "a", "b", "c", "d"};
    case FieldKind::image:
      return {"file", "u", "v"};
    case FieldKind::number:
    case FieldKind::id:
    case FieldKind::choice:
    case FieldKind::text:
    case FieldKind::file:
      break;
  }
  return {"v"};
}

std::vector<std::string> start_of(const FieldWord& word) {
  std::vector<std::string> values;
  for (std::size_t at = 0; at <= word.start.size();) {
    const std::size_t end = std::min(word.start.find(' ', at), word.start.size());
    values.emplace_back(word.start.substr(at, end - at));
    at = end + 1;
  }
  return values;
}

}  // namespace scenefile
