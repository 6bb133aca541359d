// Edits that move, turn, scale and place items in the world.

#include "scenefile/edit/placing.h"

#include "scenefile/base/number.h"
#include "scenefile/edit/document_state.h"
#include "scenefile/edit/edits.h"
#include "scenefile/edit/layout.h"
#include "scenefile/scene/transforms.h"

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace scenefile {

namespace {

using Typed = std::vector<std::optional<std::string>>;

glm::dmat4 matrix_of(const DAffine& map) {
  glm::dmat4 m(map.linear);
  m[3] = glm::dvec4(map.offset, 1);
  return m;
}

bool is_finite(const glm::dmat4& m) {
  const double* const first = &m[0][0];
  return std::all_of(first, first + 16, [](double value) { return std::isfinite(value); });
}

glm::dmat4 world_of(const Document& document, ItemId id) {
  std::vector<NodeId> nodes;
  for (ItemId at = id; at != no_item; at = document[at].parent) {
    const ItemKind kind = document[at].kind;
    if (kind != ItemKind::root && kind != ItemKind::light && placed_item(document, at) == at) {
      nodes.push_back(document[at].node);
    }
  }
  DAffine map;
  for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
    map = composed(map, document.scene().nodes[*node].transforms);
  }
  return matrix_of(map);
}

std::vector<FieldView> transforms_of(const Document& document, ItemId id) {
  std::vector<FieldView> fields;
  for (FieldView& field : document.fields(id)) {
    if (field.transform && field.written) {
      fields.push_back(std::move(field));
    }
  }
  return fields;
}

const FieldView* named(const std::vector<FieldView>& fields, std::string_view name) {
  const auto found = std::find_if(fields.begin(), fields.end(),
                                  [&](const FieldView& field) { return field.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

// A number with few digits.
std::string tidy(double number) {
  return number_text(
      static_cast<float>(std::strtod(fmt::format("{:.6g}", number).c_str(), nullptr)));
}

std::string fixed(double number, int digits) {
  return tidy(std::strtod(fmt::format("{:.{}f}", number, digits).c_str(), nullptr));
}

glm::dquat turn_about(glm::dvec3 axis, double degrees) {
  const double length = glm::length(axis);
  return length > 0 ? glm::angleAxis(glm::radians(degrees), axis / length) : glm::dquat(1, 0, 0, 0);
}

// x, y, z and degrees from 0 to 180.
std::array<double, 4> axis_angle(const glm::dquat& turn) {
  const glm::dvec3 v(turn.x, turn.y, turn.z);
  const double length = glm::length(v);
  if (length < 1e-9) {
    return {0, 1, 0, 0};
  }
  const double degrees = glm::degrees(2 * std::atan2(length, turn.w));
  const double sign = degrees > 180 ? -1 : 1;
  return {sign * v.x / length, sign * v.y / length, sign * v.z / length,
          degrees > 180 ? 360 - degrees : degrees};
}

// A map as translation, rotation and scale; nullopt if it needs a shear.
struct Decomposed {
  glm::dvec3 translation;
  glm::dquat rotation;
  glm::dvec3 scale;
};

std::optional<Decomposed> decomposed(const glm::dmat4& m, const glm::dvec3& signs) {
  Decomposed parts;
  parts.translation = glm::dvec3(m[3]);
  glm::dmat3 axes(m);
  for (int i = 0; i < 3; ++i) {
    parts.scale[i] = glm::length(axes[i]) * signs[i];
    if (parts.scale[i] == 0) {
      return std::nullopt;
    }
    axes[i] /= parts.scale[i];
  }
  if (glm::determinant(axes) < 0) {
    parts.scale.x = -parts.scale.x;
    axes[0] = -axes[0];
  }
  for (int i = 0; i < 3; ++i) {
    if (std::abs(glm::dot(axes[i], axes[(i + 1) % 3])) > 1e-6) {
      return std::nullopt;
    }
  }
  parts.rotation = glm::normalize(glm::quat_cast(axes));
  return parts;
}

Typed texts_of(std::span<const double> numbers) {
  Typed texts;
  for (const double number : numbers) {
    texts.emplace_back(number_text(static_cast<float>(number)));
  }
  return texts;
}

// The same values for the parts that differ or cannot be read; whether any does.
bool keep_equal(const FieldView& field, Typed& texts) {
  bool any = false;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const ParsedNumber now = parse_number(field.parts[i].value);
    if (field.parts[i].written && now.error == NumberError::none &&
        static_cast<float>(now.value) == static_cast<float>(parse_number(*texts[i]).value)) {
      texts[i].reset();
    }
    any = any || texts[i].has_value();
  }
  return any;
}

// Several edits of one document as one.
class Joined {
 public:
  void add(Result<Edit> edit) {
    if (!edit) {
      error_ = error_ ? error_ : edit.error();
      return;
    }
    for (TextChange& change : edit->changes) {
      changes_.push_back(std::move(change));
    }
  }
  Result<Edit> result() {
    return error_ ? Result<Edit>(*error_) : Result<Edit>(edit_of(std::move(changes_)));
  }

 private:
  std::vector<TextChange> changes_;
  std::optional<Error> error_;
};

// Whether an item has at most a translation, a rotation and a scale, in this order, before its
// object.
bool is_simple(const std::vector<FieldView>& fields, const SceneItem& item, bool xml) {
  constexpr std::string_view order[] = {"translate", "rotate", "scale"};
  std::size_t next = 0;
  for (const FieldView& field : fields) {
    const auto* const found = std::find(std::begin(order), std::end(order), field.name);
    const auto at = static_cast<std::size_t>(found - std::begin(order));
    const bool last = xml && (item.element == no_part || field.element > item.element);
    if (at == std::size(order) || (xml && at < next) || last) {
      return false;
    }
    next = at + 1;
  }
  return true;
}

// Replaces the transforms of an item by one matrix.
Result<Edit> set_matrix(const Document& document, ItemId id, const std::vector<FieldView>& fields,
                        const glm::dmat4& m) {
  std::vector<double> rows;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      rows.push_back(m[column][row]);
    }
  }
  Typed texts = texts_of(rows);
  if (fields.size() == 1 && fields[0].kind == ValueKind::matrix) {
    const PartId element = fields[0].element;
    const bool whole = document.state().syntax[element].children.size() == 4;
    if (!whole) {
      return set_values(document, id, fields[0], texts);
    }
    return keep_equal(fields[0], texts) ? set_values(document, id, fields[0], texts) : Edit{};
  }
  if (fields.empty()) {
    std::vector<double> numbers;
    for (const auto& text : texts) {
      numbers.push_back(parse_number(*text).value);
    }
    return add_transform(document, id, "matrix", numbers);
  }
  const Syntax& syntax = document.state().syntax;
  const Layout layout(syntax);
  Fresh fresh;
  for (std::size_t row = 0; row < 4; ++row) {
    Fresh line;
    line.type = document.is_xml() ? Fresh::Type::element : Fresh::Type::list;
    line.text = document.is_xml() ? "row" : "";
    for (std::size_t column = 0; column < 4; ++column) {
      const std::string& number = *texts[4 * row + column];
      if (document.is_xml()) {
        line.attributes.emplace_back(std::string(1, static_cast<char>('a' + column)), number);
      } else {
        line.children.push_back({Fresh::Type::literal, number});
      }
    }
    fresh.children.push_back(std::move(line));
  }
  fresh.type = document.is_xml() ? Fresh::Type::element : Fresh::Type::list;
  fresh.text = document.is_xml() ? "matrix" : "";
  const Piece piece{std::move(fresh), {}};
  const FieldView* first = &fields[0];
  for (const FieldView& field : fields) {
    first = field.place.from < first->place.from ? &field : first;
  }
  const std::string indent(layout.indent_at(first->place.from));
  std::string text = document.is_xml() ? "" : "\"matrix\": ";
  text += layout.text_of(piece, indent, !layout.one_line());
  std::vector<TextChange> changes{{first->place.from, first->place.size(), std::move(text)}};
  std::vector<std::size_t> gone;
  for (const FieldView& field : fields) {
    if (&field != first && document.is_xml()) {
      changes.push_back(layout.remove_element(field.place));
    } else if (&field != first) {
      gone.push_back(syntax.index(field.element));
    }
  }
  std::sort(gone.begin(), gone.end());
  if (!gone.empty()) {
    for (TextChange& change : layout.remove_entries(document[id].element, gone)) {
      changes.push_back(std::move(change));
    }
  }
  return edit_of(std::move(changes));
}

}  // namespace

ItemId placed_item(const Document& document, ItemId id) {
  const ItemKind kind = document[id].kind;
  const bool own = document.is_xml() || (kind != ItemKind::primitive && kind != ItemKind::light &&
                                         kind != ItemKind::instance);
  return own ? id : document[id].parent;
}

std::optional<Handle> handle_of(const Document& document, ItemId id) {
  ItemId top = id;
  while (document[top].parent != no_item) {
    top = document[top].parent;
  }
  return document[top].kind == ItemKind::master ? std::nullopt : handle_in_tree(document, id);
}

std::optional<glm::dmat4> tree_from_item(const Document& document, ItemId id) {
  const glm::dmat4 world = world_of(document, id);
  return is_finite(world) ? std::optional(world) : std::nullopt;
}

std::optional<Handle> handle_in_tree(const Document& document, ItemId id) {
  Handle handle;
  if (document.is_xml() && document[id].kind == ItemKind::light) {
    const std::vector<FieldView> fields = document.fields(id);
    const FieldView* const position = named(fields, "position");
    if (position == nullptr || !position->written || !position->effective) {
      return std::nullopt;
    }
    handle = {id, glm::dmat4(1), glm::dmat4(1), true};
    for (int i = 0; i < 3; ++i) {
      handle.world_from_item[3][i] = number_of(position->parts[static_cast<std::size_t>(i)]);
    }
  } else {
    const ItemId placed = placed_item(document, id);
    if (placed == no_item || document[placed].shared || document[placed].parent == no_item ||
        (document.is_xml() && document[placed].block == no_part)) {
      return std::nullopt;
    }
    handle = {placed, world_of(document, document[placed].parent), world_of(document, placed),
              false};
  }
  const bool known = is_finite(handle.world_from_space) && is_finite(handle.world_from_item);
  return known ? std::optional(handle) : std::nullopt;
}

Result<Edit> move_item(const Document& document, const Handle& handle, const glm::dvec3& delta,
                       double step) {
  const auto rounded = [&](double number) {
    return tidy(step > 0 ? std::round(number / step) * step : number);
  };
  const std::vector<FieldView> all = document.fields(handle.item);
  const std::vector<FieldView> transforms = transforms_of(document, handle.item);
  const FieldView* field = named(all, handle.is_light ? "position" : "translate");
  if (document.is_xml() && !handle.is_light) {
    field = !transforms.empty() && transforms[0].name == "translate" ? &transforms[0] : nullptr;
  }
  if (field == nullptr) {
    const std::array<double, 3> numbers{parse_number(rounded(delta.x)).value,
                                        parse_number(rounded(delta.y)).value,
                                        parse_number(rounded(delta.z)).value};
    return add_transform(document, handle.item, "translate", numbers, 0);
  }
  Typed values(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const double by = delta[static_cast<int>(i)];
    if (by != 0 || !field->written) {
      values[i] = rounded(number_of(field->parts[i]) + by);
    }
  }
  return set_values(document, handle.item, *field, values);
}

Result<Edit> scale_item(const Document& document, const Handle& handle, int axis, double factor) {
  if (handle.is_light) {
    return input_error("a light has no size to scale");
  }
  const std::vector<FieldView> all = document.fields(handle.item);
  const std::vector<FieldView> transforms = transforms_of(document, handle.item);
  const FieldView* field = named(all, "scale");
  if (document.is_xml()) {
    field = nullptr;
    for (const FieldView& some : transforms) {
      field = some.name == "scale" ? &some : field;
    }
  }
  const auto scaled = [&](double value) {
    const std::string text = fixed(value * factor, 4);
    return parse_number(text).value == 0 ? std::string("0.0001") : text;
  };
  if (field == nullptr) {
    std::array<double, 3> numbers{1, 1, 1};
    numbers[static_cast<std::size_t>(axis)] = parse_number(scaled(1)).value;
    return add_transform(document, handle.item, "scale", numbers);
  }
  const auto i = static_cast<std::size_t>(axis);
  return set_value(document, handle.item, *field, i, scaled(number_of(field->parts[i])));
}

Result<Edit> turn_item(const Document& document, const Handle& handle, int axis, double degrees) {
  if (handle.is_light) {
    return input_error("a light is turned by its direction");
  }
  glm::dvec3 about(0);
  about[axis] = 1;
  const std::vector<FieldView> all = document.fields(handle.item);
  const std::vector<FieldView> transforms = transforms_of(document, handle.item);
  std::size_t lead = 0;
  while (lead < transforms.size() && transforms[lead].name == "translate") {
    ++lead;
  }
  const FieldView* field = named(all, "rotate");
  if (document.is_xml()) {
    field =
        lead < transforms.size() && transforms[lead].name == "rotate" ? &transforms[lead] : nullptr;
  }
  if (field == nullptr) {
    const std::array<double, 4> numbers{about.x, about.y, about.z,
                                        parse_number(tidy(degrees)).value};
    return add_transform(document, handle.item, "rotate", numbers, lead);
  }
  std::array<double, 4> now{};
  for (std::size_t i = 0; i < 4; ++i) {
    now[i] = number_of(field->parts[i]);
  }
  const glm::dvec3 old(now[0], now[1], now[2]);
  const bool along = old[axis] != 0 && glm::length(old * (glm::dvec3(1) - about)) == 0;
  if (along && field->written) {  // the same axis keeps its length and sign
    return set_value(document, handle.item, *field, 3,
                     fixed(now[3] + (old[axis] < 0 ? -degrees : degrees), 2));
  }
  const std::array<double, 4> together =
      axis_angle(turn_about(about, degrees) * turn_about(old, now[3]));
  Typed values(4);
  for (std::size_t i = 0; i < 4; ++i) {
    values[i] = fixed(together[i], i < 3 ? 5 : 2);
  }
  return set_values(document, handle.item, *field, values);
}

Result<Edit> place_item(const Document& document, const Handle& handle,
                        const glm::dmat4& world_from_item) {
  if (!is_finite(world_from_item) ||
      std::abs(glm::determinant(glm::dmat3(handle.world_from_space))) < 1e-30) {
    return input_error("its group is scaled to nothing, so it cannot be placed in the world");
  }
  const glm::dmat4 local = glm::inverse(handle.world_from_space) * world_from_item;
  if (!is_finite(glm::dmat4(glm::mat4(local)))) {
    return input_error("its place in the group needs numbers that are too large for a scene file");
  }
  const std::vector<FieldView> all = document.fields(handle.item);
  if (handle.is_light) {
    const FieldView& position = *named(all, "position");
    Typed texts = texts_of(std::array<double, 3>{local[3].x, local[3].y, local[3].z});
    return keep_equal(position, texts) ? set_values(document, handle.item, position, texts)
                                       : Edit{};
  }
  const std::vector<FieldView> transforms = transforms_of(document, handle.item);
  glm::dvec3 signs(1);
  if (const FieldView* const scale = named(transforms, "scale")) {
    for (std::size_t i = 0; i < 3; ++i) {
      signs[static_cast<int>(i)] = number_of(scale->parts[i]) < 0 ? -1 : 1;
    }
  }
  const std::optional<Decomposed> parts = decomposed(local, signs);
  // Several parts cannot be inserted one by one into something empty.
  const SceneItem& item = document[handle.item];
  const PartId container = document.is_xml() ? item.block : item.element;
  const bool is_empty = document.state().syntax[container].children.empty();
  if (!parts || !is_simple(transforms, item, document.is_xml()) || is_empty) {
    return set_matrix(document, handle.item, transforms, local);
  }
  const std::array<double, 4> turn = axis_angle(parts->rotation);
  const glm::dvec3& t = parts->translation;
  const glm::dvec3& s = parts->scale;
  const std::pair<std::string_view, std::vector<double>> wanted[] = {
      {"translate", {t.x, t.y, t.z}},
      {"rotate", {turn[0], turn[1], turn[2], turn[3]}},
      {"scale", {s.x, s.y, s.z}}};
  const auto idle = [&](std::size_t i) {
    return i == 0   ? t == glm::dvec3(0)
           : i == 1 ? std::abs(turn[3]) < 1e-7
                    : glm::length(s - glm::dvec3(1)) < 1e-9;
  };
  // New transforms that come one after another are inserted together.
  Joined edit;
  std::size_t before = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [name, numbers] = wanted[i];
    if (const FieldView* const field = named(transforms, name)) {
      Typed texts = texts_of(numbers);
      if (i == 1) {
        const glm::dvec3 axis(number_of(field->parts[0]), number_of(field->parts[1]),
                              number_of(field->parts[2]));
        const glm::dquat now = turn_about(axis, number_of(field->parts[3]));
        if (std::abs(glm::dot(now, parts->rotation)) > 1 - 1e-14) {
          texts.assign(4, std::nullopt);
        }
      }
      const bool any = std::any_of(texts.begin(), texts.end(), [](const auto& x) { return !!x; });
      if (any && keep_equal(*field, texts)) {
        edit.add(set_values(document, handle.item, *field, texts));
      }
      ++before;
    } else if (!idle(i)) {
      edit.add(add_transform(document, handle.item, name, numbers, before));
    }
  }
  return edit.result();
}

}  // namespace scenefile
