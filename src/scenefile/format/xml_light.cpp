#include "scenefile/base/number.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/foreign_names.h"
#include "scenefile/format/xml_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace scenefile {

namespace {

constexpr auto light_names = names_of<count_names(light_rows)>(light_rows);

bool has(const LightDraft& draft, Field field) {
  return draft.seen.has(index_of(light_rows, field));
}

void read_type(const XmlContext& context, Location place, std::string_view word,
               LightDraft& draft) {
  for (std::size_t i = 0; i < light_words.size(); ++i) {
    if (!equal_ignoring_case(word, light_words[i])) {
      continue;
    }
    draft.light.type = static_cast<LightType>(i);
    if (word != light_words[i]) {
      context.diagnostics.report(
          xml_name_case, place,
          fmt::format("light type {} was read as {}", quoted(word), light_words[i]));
    }
    return;
  }
  const std::string_view usual = translated_name(word, light_words);
  const std::string_view near = usual.empty() ? nearest_name(word, light_words) : usual;
  const auto meant = std::find(light_words.begin(), light_words.end(), near);
  draft.type_known = meant != light_words.end();
  draft.light.type =
      draft.type_known ? static_cast<LightType>(meant - light_words.begin()) : LightType::point;
  context.diagnostics.report(
      xml_light_type, place,
      fmt::format(
          "unknown light type {}{}", quoted(word),
          near.empty() ? "; the types are point, directional, spot and area" : did_you_mean(near)));
}

void read_id(const XmlContext& context, Location place, std::string_view word, Light& light) {
  const ParsedNumber number = parse_number(word);
  const bool whole = number.error == NumberError::none && std::trunc(number.value) == number.value;
  if (whole && std::abs(number.value) <= std::numeric_limits<int>::max()) {
    light.id = static_cast<int>(number.value);
    return;
  }
  context.diagnostics.report(
      xml_light_id, place,
      fmt::format("the light id {} is not a whole number from 0 to 7; it has no effect",
                  quoted(word)));
}

// Reports values that the light's type does not use.
void report_unused(const XmlContext& context, const LightDraft& draft) {
  for (std::size_t i = 0; i < std::size(light_rows); ++i) {
    const ValueRow<Light>& row = light_rows[i];
    if (draft.seen.has(i) && !row.used_by_type(draft.light.type) && !row.idle_in_xml) {
      context.diagnostics.report(
          xml_light_unused, draft.seen.place(i),
          fmt::format("<{}> has no effect on a {} light", row.xml, word_of(draft.light.type)));
    }
  }
}

void report_defaults(const XmlContext& context, const LightDraft& draft) {
  const LightType type = draft.light.type;
  const auto missing = [&](Field field, std::string_view value) {
    if (!has(draft, field)) {
      context.diagnostics.report(xml_light_default, draft.light.location,
                                 fmt::format("the {} light has no <{}>; the default {} is used",
                                             word_of(type), row_of(light_rows, field).xml, value));
    }
  };
  if (light_uses(type, Field::position)) {
    missing(Field::position, "3 3 3");
  }
  missing(Field::color, "1 1 1");
  if (!has(draft, Field::id) && !draft.light.id) {
    context.diagnostics.report(xml_light_id, draft.light.location,
                               "the light has no <id>; give each light a number from 0 to 7");
  }
  if (light_uses(type, Field::penumbra_deg) && has(draft, Field::angle_deg)) {
    missing(Field::penumbra_deg, "0");
  }
}

}  // namespace

LightDraft begin_light(const XmlContext& context, const XmlTag& tag) {
  constexpr std::string_view known[] = {"id", "type"};
  LightDraft draft;
  draft.light.location = tag.location;
  draft.light.position = glm::vec3(3);
  for (const XmlAttribute& attribute : tag.attributes) {
    const bool is_type = attribute.name == "type";
    if (!is_type && attribute.name != "id") {
      report_block_attribute(context, tag, attribute, known);
      continue;
    }
    context.report(xml_alias_attribute, attribute,
                   fmt::format("attribute {0} of <lightdata> was read as <{0}>", attribute.name));
    const Location place = context.place(attribute);
    if (is_type) {
      read_type(context, place, attribute.value, draft);
    } else {
      read_id(context, place, attribute.value, draft.light);
    }
  }
  return draft;
}

bool read_light_part(const XmlContext& context, const XmlTag& tag, LightDraft& draft) {
  const std::optional<std::size_t> field = find_field(context, tag, light_names, "lightdata");
  if (!field) {
    return false;
  }
  draft.seen.note(context, tag, *field);
  const ValueRow<Light>& row = light_rows[*field];
  if (row.kind == ValueKind::id) {
    if (const std::optional<std::string_view> word = read_word(context, tag)) {
      read_id(context, tag.location, *word, draft.light);
    }
  } else if (row.kind == ValueKind::word) {
    if (const std::optional<std::string_view> word = read_word(context, tag)) {
      read_type(context, tag.location, *word, draft);
    } else {
      draft.type_known = false;
    }
  } else if (!row.has_member()) {
    context.report(xml_ignored_element, tag, fmt::format("<{}> of a light has no effect", row.xml));
  } else {
    read_value(context, tag, row, draft.light);
  }
  return true;
}

void finish_light(const XmlContext& context, LightDraft& draft, Scene& scene) {
  if (draft.type_known) {
    report_unused(context, draft);
    report_defaults(context, draft);
  }
  if (!light_uses(draft.light.type, Field::position) && !has(draft, Field::position)) {
    draft.light.position = glm::vec3(0);
  }
  add_places(light_rows, draft.seen, draft.light.location, scene);
  scene.nodes[scene.root].lights.push_back(std::move(draft.light));
}

}  // namespace scenefile
