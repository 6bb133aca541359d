#include "scenefile/edit/field_words.h"

#include <algorithm>
#include <vector>

namespace scenefile {

namespace {

template <typename Owner, std::size_t N>
void append(std::vector<FieldWord>& words, const ValueRow<Owner> (&rows)[N]) {
  for (const ValueRow<Owner>& row : rows) {
    const ValueWords& say = row.words;
    if (say.title.empty()) {
      continue;
    }
    FieldWord& word = words.emplace_back(FieldWord{row.xml, row.json, say.title, row.kind,
                                                   say.start, row.range, row.need, row.edited});
    if (row.kind == ValueKind::image) {  // in JSON three entries
      word.json = {};
      const std::string_view file = say.start.substr(0, say.start.find(' '));
      words.push_back({{}, row.json, say.title, ValueKind::file, file});
      for (const RepeatKey& repeat : row.json_repeat) {
        words.push_back({{}, repeat.key, repeat.title, ValueKind::number, "1", row.range});
      }
    }
  }
}

template <typename Owner, std::size_t N>
std::vector<FieldWord> words_of_rows(const ValueRow<Owner> (&rows)[N]) {
  std::vector<FieldWord> words;
  append(words, rows);
  return words;
}

std::vector<FieldWord> words_of_primitive() {
  std::vector<FieldWord> words{
      {{}, "type", shape_field.title, ValueKind::choice, shape_field.start, {}, Need::always},
      {{}, "meshFile", mesh_field.title, ValueKind::file, mesh_field.start, {}, Need::always}};
  append(words, material_rows);
  return words;
}

}  // namespace

std::span<const FieldWord> words_of(ItemKind kind) {
  static const std::vector<FieldWord> globals = words_of_rows(global_rows);
  static const std::vector<FieldWord> camera = words_of_rows(camera_rows);
  static const std::vector<FieldWord> light = words_of_rows(light_rows);
  static const std::vector<FieldWord> primitive = words_of_primitive();
  switch (kind) {
    case ItemKind::globals:
      return globals;
    case ItemKind::camera:
      return camera;
    case ItemKind::light:
      return light;
    case ItemKind::primitive:
      return primitive;
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
      const bool usual = row.kind == ValueKind::id || row.kind == ValueKind::choice;
      return {usual || light_needs(light, row, xml),
              row.used_by_type(light) || (xml && row.idle_in_xml)};
    }
  }
  return {};
}

std::vector<std::string_view> parts_of(const FieldWord& word, bool xml) {
  switch (word.kind) {
    case ValueKind::vector:
      return {"x", "y", "z"};
    case ValueKind::color:
      return {"r", "g", "b"};
    case ValueKind::coefficients:
      return xml ? std::vector<std::string_view>{"v1", "v2", "v3"}
                 : std::vector<std::string_view>{"constant", "linear", "quadratic"};
    case ValueKind::rotation:
      return {"x", "y", "z", "angle"};
    case ValueKind::matrix:
      return {"a", "b", "c", "d", "a", "b", "c", "d", "a", "b", "c", "d", "a", "b", "c", "d"};
    case ValueKind::image:
      return {"file", "u", "v"};
    case ValueKind::number:
    case ValueKind::id:
    case ValueKind::choice:
    case ValueKind::text:
    case ValueKind::file:
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
