#include "scenefile/format/xml_light.h"

#include "scenefile/base/number.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/other_words.h"
#include "scenefile/format/xml_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace scenefile {

namespace {

enum LightField : std::size_t {
  l_id,
  l_type,
  l_color,
  l_function,
  l_position,
  l_direction,
  l_penumbra,
  l_angle,
  l_radius,
  l_width,
  l_height
};

constexpr FieldName light_names[] = {{"id", l_id},
                                     {"number", l_id, true},
                                     {"type", l_type},
                                     {"color", l_color},
                                     {"function", l_function},
                                     {"position", l_position},
                                     {"direction", l_direction},
                                     {"penumbra", l_penumbra},
                                     {"angle", l_angle},
                                     {"radius", l_radius},
                                     {"width", l_width},
                                     {"height", l_height}};

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
  const std::string_view usual = in_our_words(word, light_words);
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

template <typename Value>
void set(Value& member, const std::optional<Value>& value) {
  member = value.value_or(Value(not_known));
}

// Values that the light's type has no use for.
void report_unused(const XmlContext& context, const LightDraft& draft) {
  const LightType type = draft.light.type;
  const auto unless = [&](bool used, LightField field, std::string_view name) {
    if (!used && draft.seen.has(field)) {
      context.diagnostics.report(
          xml_light_unused, draft.seen.place(field),
          fmt::format("<{}> has no effect on a {} light", name, word_of(type)));
    }
  };
  unless(type != LightType::directional, l_position, "position");
  unless(type != LightType::point, l_direction, "direction");
  unless(type == LightType::spot, l_penumbra, "penumbra");
  unless(type == LightType::spot, l_angle, "angle");
  unless(type == LightType::area, l_width, "width");
  unless(type == LightType::area, l_height, "height");
}

void report_defaults(const XmlContext& context, const LightDraft& draft) {
  const LightType type = draft.light.type;
  const auto missing = [&](LightField field, std::string_view name, std::string_view value) {
    if (!draft.seen.has(field)) {
      context.diagnostics.report(xml_light_default, draft.light.location,
                                 fmt::format("the {} light has no <{}>; the default {} is used",
                                             word_of(type), name, value));
    }
  };
  if (type != LightType::directional) {
    missing(l_position, "position", "3 3 3");
  }
  missing(l_color, "color", "1 1 1");
  if (!draft.seen.has(l_id) && !draft.light.id) {
    context.diagnostics.report(xml_light_id, draft.light.location,
                               "the light has no <id>; give each light a number from 0 to 7");
  }
  if (type == LightType::spot && draft.seen.has(l_angle)) {
    missing(l_penumbra, "penumbra", "0");
  }
}

void add_places(const LightDraft& draft, Scene& scene) {
  constexpr std::pair<LightField, Field> members[] = {{l_id, Field::id},
                                                      {l_color, Field::color},
                                                      {l_function, Field::attenuation},
                                                      {l_position, Field::position},
                                                      {l_direction, Field::direction},
                                                      {l_penumbra, Field::penumbra_deg},
                                                      {l_angle, Field::angle_deg},
                                                      {l_width, Field::width},
                                                      {l_height, Field::height}};
  for (const auto& [field, member] : members) {
    if (draft.seen.has(field)) {
      scene.field_places.push_back({draft.light.location, member, draft.seen.place(field)});
    }
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
    const Location place = context.places.inside_tag(attribute.name.data());
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
  Light& light = draft.light;
  switch (static_cast<LightField>(*field)) {
    case l_id:
      if (const std::optional<std::string_view> word = read_word(context, tag)) {
        read_id(context, tag.location, *word, light);
      }
      break;
    case l_type:
      if (const std::optional<std::string_view> word = read_word(context, tag)) {
        read_type(context, tag.location, *word, draft);
      } else {
        draft.type_known = false;
      }
      break;
    case l_color:
      set(light.color, read_color(context, tag));
      break;
    case l_function:
      set(light.attenuation, read_attenuation(context, tag));
      break;
    case l_position:
      set(light.position, read_vector(context, tag));
      break;
    case l_direction:
      set(light.direction, read_vector(context, tag));
      break;
    case l_penumbra:
      set(light.penumbra_deg, read_single(context, tag));
      break;
    case l_angle:
      light.angle_deg = read_single(context, tag).value_or(not_known);
      break;
    case l_radius:
      context.report(xml_ignored_element, tag, "<radius> of a light has no effect");
      break;
    case l_width:
      set(light.width, read_single(context, tag));
      break;
    case l_height:
      set(light.height, read_single(context, tag));
      break;
  }
  return true;
}

void finish_light(const XmlContext& context, LightDraft& draft, Scene& scene) {
  if (draft.type_known) {
    report_unused(context, draft);
    report_defaults(context, draft);
  }
  if (draft.light.type == LightType::directional && !draft.seen.has(l_position)) {
    draft.light.position = glm::vec3(0);
  }
  add_places(draft, scene);
  scene.nodes[scene.root].lights.push_back(std::move(draft.light));
}

}  // namespace scenefile
