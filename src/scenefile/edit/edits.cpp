#include "scenefile/edit/edits.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/number.h"
#include "scenefile/base/text.h"
#include "scenefile/edit/document_state.h"
#include "scenefile/edit/layout.h"
#include "scenefile/edit/placing.h"
#include "scenefile/edit/template_name.h"
#include "scenefile/format/xml_scanner.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <utility>

namespace scenefile {

namespace {

using Values = std::vector<std::optional<std::string>>;

// Descriptions of new elements and values.

Fresh literal(std::string text) {
  return {Fresh::Type::literal, std::move(text)};
}

Fresh object_of(std::vector<Fresh> members) {
  return {Fresh::Type::object, {}, {}, std::move(members)};
}

Fresh list_of(std::vector<Fresh> values) {
  return {Fresh::Type::list, {}, {}, std::move(values)};
}

Fresh element_of(std::string name, std::vector<std::pair<std::string, std::string>> attributes,
                 std::vector<Fresh> children = {}) {
  return {Fresh::Type::element, std::move(name), std::move(attributes), std::move(children)};
}

Fresh member(std::string_view key, Fresh value) {
  value.key = key;
  return value;
}

bool is_word(ValueKind kind) {
  return kind == ValueKind::choice || kind == ValueKind::text || kind == ValueKind::file;
}

std::string json_literal(const FieldWord& word, const std::string& value) {
  return is_word(word.kind) ? json_quoted(value) : value;
}

Fresh fresh_entry(const FieldWord& word, const Values& values) {
  const std::vector<std::string> start = start_of(word);
  std::vector<Fresh> parts;
  for (std::size_t i = 0; i < parts_of(word, false).size(); ++i) {
    const std::string& given = start[std::min(i, start.size() - 1)];
    parts.push_back(
        literal(json_literal(word, i < values.size() && values[i] ? *values[i] : given)));
  }
  if (word.kind == ValueKind::matrix) {
    std::vector<Fresh> rows;
    for (auto row = parts.begin(); row != parts.end(); row += 4) {
      rows.push_back(list_of({row, row + 4}));
    }
    return list_of(std::move(rows));
  }
  return parts.size() == 1 ? std::move(parts[0]) : list_of(std::move(parts));
}

bool is_fixed(const SceneItem& item) {
  return item.kind == ItemKind::globals || item.kind == ItemKind::camera ||
         item.kind == ItemKind::root;
}

bool is_group(const SceneItem& item) {
  return item.kind == ItemKind::group || item.kind == ItemKind::master ||
         item.kind == ItemKind::root;
}

std::string_view list_for(ItemKind kind) {
  return kind == ItemKind::light ? "lights" : kind == ItemKind::primitive ? "primitives" : "groups";
}

// An insertion and a removal that touch become one change, so that their order is defined.
std::vector<TextChange> merged(std::vector<TextChange> changes) {
  sort_changes(changes);
  std::vector<TextChange> result;
  for (TextChange& change : changes) {
    const std::uint32_t end = result.empty() ? 0 : result.back().at + result.back().size;
    if (change.size == 0 && change.at < end) {  // before something that is removed
      result.back().text += change.text;
    } else if (!result.empty() && result.back().size != 0 && change.at == end) {
      result.back().text += change.text;
      result.back().size += change.size;
    } else {
      result.push_back(std::move(change));
    }
  }
  return result;
}

// In JSON, the group around a single object or light is only its place.
ItemId with_place(const Document& document, ItemId item) {
  const ItemId around = document[item].parent;
  const bool alone =
      !document.is_xml() && around != no_item && document[item].kind != ItemKind::group &&
      document[around].kind == ItemKind::group && document[around].children.size() == 1;
  return alone ? around : item;
}

// The ambient color of new objects, which can be seen in the shadow.
Values dim_gray() {
  return Values(3, "0.2");
}

// Makes the changes of one document.
class Editor {
 public:
  explicit Editor(const Document& document)
      : document_(document),
        state_(document.state()),
        syntax_(state_.syntax),
        layout_(syntax_),
        reader_(state_) {}

  // `file`: of a primitive that becomes a mesh.
  Result<Edit> set(ItemId id, const FieldView& field, const Values& values,
                   std::string_view file) const {
    const SceneItem& item = document_[id];
    if (field.title == name_field.title && *values[0] != item.name) {
      if (std::string why = name_refusal(item, *values[0]); !why.empty()) {
        return input_error(std::move(why));
      }
    }
    if (item.kind == ItemKind::master && field.name == "name") {
      return edit_of(renamed(item, *values[0]));
    }
    if (item.kind == ItemKind::light && field.name == "type") {
      return edit_of(retyped(item, field, *values[0], {}));
    }
    std::vector<TextChange> changes = value_changes(item, field, values);
    if (item.kind == ItemKind::primitive && field.title == shape_field.title) {
      for (TextChange& change : mesh_file_changes(item, field, *values[0], file)) {
        changes.push_back(std::move(change));
      }
    }
    return edit_of(std::move(changes));
  }

  Edit unset(const SceneItem& item, const FieldView& field) const {
    if (field.element == no_part) {
      std::size_t from = field.place.from;
      while (from > 0 && blanks.find(state_.text[from - 1]) != blanks.npos) {
        --from;
      }
      return edit_of({{static_cast<std::uint32_t>(from),
                       static_cast<std::uint32_t>(field.place.to - from), ""}});
    }
    return edit_of(removal_of_fields(item, {field.element}));
  }

  std::vector<TextChange> value_changes(const SceneItem& item, const FieldView& field,
                                        const Values& values) const {
    return syntax_.xml ? xml_changes(item, field, values) : json_changes(item, field, values);
  }

  const FieldWord& word_of(ItemKind kind, std::string_view name) const {
    for (const FieldWord& word : words_of(kind)) {
      if (word.name(syntax_.xml) == name) {
        return word;
      }
    }
    for (const FieldWord& word : transform_fields) {
      if (word.xml == name) {
        return word;
      }
    }
    return name_field;
  }

  Fresh fresh_element(const FieldWord& word, const Values& values) const {
    const std::vector<std::string_view> names = parts_of(word, true);
    const std::vector<std::string> start = start_of(word);
    std::vector<std::pair<std::string, std::string>> attributes;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const bool given = i < values.size() && values[i];
      if (given || word.kind != ValueKind::image || i == 0) {
        attributes.emplace_back(
            names[i],
            state_.attribute_value(given ? *values[i] : start[std::min(i, start.size() - 1)]));
      }
    }
    Fresh element = element_of(std::string(word.xml), {});
    if (word.kind == ValueKind::matrix) {
      for (auto row = attributes.begin(); row != attributes.end(); row += 4) {
        element.children.push_back(element_of("row", {row, row + 4}));
      }
    } else {
      element.attributes = std::move(attributes);
    }
    return element;
  }

  // Adds fields that are not in the file, in the order of the format. `fresh` is in that order.
  std::vector<TextChange> insert_fields(
      const SceneItem& item, const std::vector<std::pair<const FieldWord*, Values>>& fresh) const {
    if (item.element == no_part ||
        (!syntax_.xml && syntax_[item.element].type != SyntaxPart::Type::object)) {
      return {new_container(item, fresh).change};
    }
    std::vector<TextChange> changes;
    for (std::size_t first = 0; first < fresh.size();) {
      const std::optional<std::size_t> before = index_before(item, *fresh[first].first);
      std::size_t end = first + 1;
      while (end < fresh.size() && index_before(item, *fresh[end].first) == before) {
        ++end;
      }
      changes.push_back(joined(item.element, before, {fresh.data() + first, end - first}).change);
      first = end;
    }
    return changes;
  }

  // Fields inserted into an element or object after its child of that index, or at the beginning.
  Insertion joined(PartId element, std::optional<std::size_t> before,
                   std::span<const std::pair<const FieldWord*, Values>> fresh) const {
    if (syntax_.xml) {
      std::vector<Piece> pieces;
      for (const auto& [word, values] : fresh) {
        pieces.push_back({fresh_element(*word, values), {}});
      }
      return layout_.insert_children(element, before ? syntax_[element].children[*before] : no_part,
                                     pieces);
    }
    const bool none = syntax_[element].children.empty();
    Insertion all;
    for (std::size_t i = 0; i < fresh.size(); ++i) {
      const auto& [word, values] = fresh[i];
      const Piece piece{fresh_entry(*word, values), {}};
      if (i > 0 && none) {
        std::string& text = all.change.text;
        text.resize(text.find_last_not_of(blanks) + 1);
        text += fmt::format(", {}: {}", json_quoted(word->json), layout_.text_of(piece, "", false));
        continue;
      }
      Insertion one = layout_.insert_entry(element, before ? *before + 1 : 0, piece, word->json);
      if (i == 0) {
        all = std::move(one);
      } else {
        all.change.text += one.change.text;
      }
    }
    return all;
  }

  // The last child that comes before a field in the order of the format.
  std::optional<std::size_t> index_before(const SceneItem& item, const FieldWord& word) const {
    const std::vector<const FieldWord*> order = ordered_words(item.kind, syntax_.xml);
    const std::vector<PartId>& children = syntax_[item.element].children;
    const std::size_t own = rank_of(item, order, word);
    for (std::size_t i = children.size(); i-- > 0;) {
      const FieldWord* const child = word_of_child(state_, reader_.context, item.kind, children[i]);
      if (child != nullptr && rank_of(item, order, *child) < own) {
        return i;
      }
    }
    return std::nullopt;
  }

  static std::size_t rank_of(const SceneItem& item, const std::vector<const FieldWord*>& order,
                             const FieldWord& word) {
    if (order.empty()) {  // a group: its name first, in a template last
      const bool is_name = word.kind == ValueKind::text;
      return is_name ? (item.kind == ItemKind::master ? 100 : 0)
                     : static_cast<std::size_t>(&word - transform_fields) + 1;
    }
    return static_cast<std::size_t>(std::find(order.begin(), order.end(), &word) - order.begin());
  }

  // Global data or a camera that the file lacks, with all that it needs.
  Insertion new_container(const SceneItem& item,
                          const std::vector<std::pair<const FieldWord*, Values>>& fresh) const {
    const bool camera = item.kind == ItemKind::camera;
    const auto given = [&](std::string_view name) {
      return std::find_if(fresh.begin(), fresh.end(),
                          [&](const auto& one) { return one.first->xml == name; });
    };
    std::vector<Fresh> elements;
    std::vector<Fresh> entries;
    for (const FieldWord* const word : ordered_words(item.kind, syntax_.xml)) {
      const auto own = given(word->xml);
      const bool needed =
          camera ? word->xml == "pos" || word->xml == "up" || word->xml == "heightangle" ||
                       (word->xml == "look" && given("focus") == fresh.end())
                 : word->xml != "transparentcoeff" && (!syntax_.xml || fresh.empty());
      if (own == fresh.end() && !needed) {
        continue;
      }
      const Values values = own == fresh.end() ? Values{} : own->second;
      if (syntax_.xml) {
        elements.push_back(fresh_element(*word, values));
      } else {
        entries.push_back(member(word->json, fresh_entry(*word, values)));
      }
    }
    const std::vector<PartId>& top = syntax_[0].children;
    const auto index_of = [&](std::string_view name) {
      std::optional<std::size_t> index;
      for (std::size_t i = 0; i < top.size(); ++i) {
        index = equal_ignoring_case(syntax_.name(top[i]), name) ? i : index;
      }
      return index;
    };
    if (syntax_.xml) {
      const Piece piece{element_of(camera ? "cameradata" : "globaldata", {}, std::move(elements)),
                        {}};
      const std::optional<std::size_t> globals = camera ? index_of("globaldata") : std::nullopt;
      return layout_.insert_children(0, globals ? top[*globals] : no_part, {&piece, 1});
    }
    const std::string_view key = camera ? "cameraData" : "globalData";
    const Piece piece{object_of(std::move(entries)), {}};
    if (const std::optional<std::size_t> wrong = index_of(key)) {
      const TextRange place = syntax_[top[*wrong]].value();
      const std::string text =
          layout_.text_of(piece, std::string(layout_.indent_at(place.from)), !layout_.one_line());
      return {{place.from, place.size(), text}, 0};
    }
    const std::optional<std::size_t> globals = camera ? index_of("globalData") : std::nullopt;
    return layout_.insert_entry(0, globals ? *globals + 1 : 0, piece, key);
  }

  // A new field, with those that it needs, or in place of its alternative.
  std::vector<TextChange> insert_field(const SceneItem& item, const FieldView& field,
                                       const Values& values) const {
    const FieldWord& word = word_of(item.kind, field.name);
    std::vector<std::pair<const FieldWord*, Values>> fresh{{&word, values}};
    const std::string_view instead = word.xml == "look"    ? "focus"
                                     : word.xml == "focus" ? "look"
                                                           : "";
    if (item.kind == ItemKind::camera && !instead.empty() && item.element != no_part) {
      for (const FieldView& other : document_.fields(1)) {
        if (other.name == instead && other.written) {
          const PartId element = syntax_[other.element].parent;
          const Insertion all = joined(element, syntax_.index(other.element), fresh);
          return {{other.place.from, other.place.size(), all.change.text.substr(all.lead)}};
        }
      }
    }
    if (item.kind == ItemKind::primitive && (word.xml == "texture" || word.json == "textureFile")) {
      const auto fields = document_.fields(id_of(item));
      const auto blend = std::find_if(fields.begin(), fields.end(),
                                      [](const FieldView& f) { return f.name == "blend"; });
      if (blend != fields.end() && !blend->written) {
        fresh.push_back({&word_of(item.kind, "blend"), {"1"}});
        if (item.element != no_part) {
          return {joined(item.element, index_before(item, word), fresh).change};
        }
      }
    }
    return insert_fields(item, fresh);
  }

  ItemId id_of(const SceneItem& item) const {
    return static_cast<ItemId>(&item - document_.items().data());
  }

  std::vector<TextChange> xml_changes(const SceneItem& item, const FieldView& field,
                                      const Values& values) const {
    if (field.element == no_part) {
      const bool own = item.kind == ItemKind::master || item.kind == ItemKind::group ||
                       item.kind == ItemKind::instance || field.title == shape_field.title ||
                       field.title == mesh_field.title;
      if (!own) {
        return insert_field(item, field, values);
      }
      const std::string value = state_.attribute_value(*values[0]);
      if (field.written) {
        const TextRange place = field.parts[0].place;
        return {{place.from, place.size(), value}};
      }
      const std::array<std::string_view, 2> after{"type", "name"};
      return {layout_.set_attribute(item.element, field.name, value,
                                    std::span(after).first(field.name == "name" ? 1 : 2))};
    }
    const bool readable =
        field.kind != ValueKind::matrix ||
        (syntax_[field.element].children.size() == 4 &&
         std::all_of(field.parts.begin(), field.parts.end(), std::mem_fn(&FieldPart::written)));
    if (!readable) {
      const Piece piece{fresh_element(word_of(item.kind, field.name), known_values(field, values)),
                        {}};
      const std::string indent(layout_.indent_at(field.place.from));
      return {{field.place.from, field.place.size(),
               comments_in(field.place) + layout_.text_of(piece, indent, !layout_.one_line())}};
    }
    std::vector<TextChange> changes;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!values[i]) {
        continue;
      }
      const std::string value = state_.attribute_value(*values[i]);
      const FieldPart& part = field.parts[i];
      changes.push_back(part.written ? TextChange{part.place.from, part.place.size(), value}
                                     : new_attribute(field, i, value));
    }
    return changes;
  }

  // The comments of a part of the text, one after another.
  std::string comments_in(TextRange range) const {
    std::string comments;
    XmlScanner scanner(std::string_view(state_.text).substr(range.from, range.size()));
    for (XmlToken token; scanner.next(token);) {
      if (token.kind == XmlTokenKind::comment) {
        comments += token.written;
        comments += ' ';
      }
    }
    return comments;
  }

  // The values with those of the field for parts that stay.
  static Values known_values(const FieldView& field, Values values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = values[i] ? values[i] : field.parts[i].value;
    }
    return values;
  }

  // A part that the element does not have yet, named like the others: v3 beside v1 and v2.
  TextChange new_attribute(const FieldView& field, std::size_t index,
                           const std::string& value) const {
    std::vector<std::string_view> names;
    for (const FieldPart& part : field.parts) {
      names.push_back(part.name);
    }
    const auto attributes = syntax_.attributes(field.element);
    constexpr std::array<std::string_view, 3> forms[] = {
        {"v1", "v2", "v3"}, {"x", "y", "z"}, {"a", "b", "c"}};
    for (const auto& form : forms) {
      const bool used = std::any_of(attributes.begin(), attributes.end(), [&](const auto& a) {
        return std::find(form.begin(), form.end(), a.name) != form.end();
      });
      if (field.kind == ValueKind::coefficients && used) {
        names.assign(form.begin(), form.end());
        break;
      }
    }
    if (field.parts.size() == 1) {
      names = {"v"};
    }
    return layout_.set_attribute(field.element, names[index], value, std::span(names).first(index));
  }

  std::vector<TextChange> json_changes(const SceneItem& item, const FieldView& field,
                                       const Values& values) const {
    if (field.element == no_part) {
      return insert_field(item, field, values);
    }
    const SyntaxPart& entry = syntax_[field.element];
    const bool whole = std::any_of(field.parts.begin(), field.parts.end(),
                                   [](const FieldPart& part) { return !part.written; }) ||
                       (field.parts.size() > 1 && !has_shape(field));
    const FieldWord& word = word_of(item.kind, field.name);
    if (!whole) {
      std::vector<TextChange> changes;
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i]) {
          const TextRange place = field.parts.size() == 1 ? entry.value() : field.parts[i].place;
          changes.push_back({place.from, place.size(), json_literal(word, *values[i])});
        }
      }
      return changes;
    }
    const Piece piece{fresh_entry(word, known_values(field, values)), {}};
    return {{entry.body, entry.value().size(), layout_.text_of(piece, "", false)}};
  }

  // Whether a list in JSON has just the parts of the field.
  bool has_shape(const FieldView& field) const {
    const SyntaxPart& list = syntax_[field.element];
    const bool matrix = field.kind == ValueKind::matrix;
    return list.type == SyntaxPart::Type::array &&
           list.children.size() == (matrix ? 4 : field.parts.size()) &&
           std::all_of(list.children.begin(), list.children.end(), [&](PartId child) {
             return matrix ? syntax_[child].children.size() == 4
                           : syntax_[child].type == SyntaxPart::Type::number;
           });
  }

  // Removes children of an element or entries of an object.
  std::vector<TextChange> removal_of_fields(const SceneItem& item, std::vector<PartId> gone) const {
    std::vector<TextChange> changes;
    if (syntax_.xml) {
      for (const PartId part : gone) {
        changes.push_back(layout_.remove_element(syntax_[part].range()));
      }
      return changes;
    }
    std::sort(gone.begin(), gone.end());
    std::vector<std::size_t> indexes;
    for (const PartId part : gone) {
      indexes.push_back(syntax_.index(part));
    }
    return layout_.remove_entries(item.element, indexes);
  }

  int free_id() const {
    std::set<int> taken;
    for (const Light& light : document_.scene().nodes[document_.scene().root].lights) {
      if (light.id) {
        taken.insert(*light.id);
      }
    }
    int id = 0;
    while (taken.contains(id)) {
      ++id;
    }
    return id;
  }

  Values values_in(std::span<const FieldView> known, const FieldWord& word) const {
    Values values;
    for (const FieldView& field : known) {
      if (field.name == word.name(syntax_.xml)) {
        for (const FieldPart& part : field.parts) {
          values.emplace_back(part.value);
        }
      }
    }
    return values;
  }

  LightUse use_of(const FieldWord& word, std::string_view type) const {
    return light_use(word.name(syntax_.xml), type, syntax_.xml);
  }

  std::vector<TextChange> retyped(const SceneItem& item, const FieldView& field,
                                  const std::string& type, std::span<const FieldView> known) const {
    std::vector<TextChange> changes;
    if (field.written) {
      changes = value_changes(item, field, {type});
    }
    std::vector<PartId> unused;
    std::vector<std::pair<const FieldWord*, Values>> missing;
    for (const FieldWord* const word : ordered_words(item.kind, syntax_.xml)) {
      PartId present = no_part;
      for (const PartId child : syntax_[item.element].children) {
        if (word_of_child(state_, reader_.context, item.kind, child) == word) {
          present = child;
        }
      }
      const LightUse use = use_of(*word, type);
      if (word->xml == "type") {
        if (!field.written) {
          missing.push_back({word, {type}});
        }
        continue;
      }
      if (present != no_part && !use.effective) {
        unused.push_back(present);
      } else if (present == no_part && use.needed) {
        missing.push_back({word, word->kind == ValueKind::id ? Values{std::to_string(free_id())}
                                                             : values_in(known, *word)});
      }
    }
    std::size_t first = 0;
    if (!syntax_.xml) {
      // Removals of neighboring entries touch, so replace entries one after another where possible.
      for (; first < std::min(unused.size(), missing.size()); ++first) {
        const TextRange place = syntax_[unused[first]].range();
        const auto& [word, values] = missing[first];
        const Piece piece{fresh_entry(*word, values), {}};
        changes.push_back(
            {place.from, place.size(),
             fmt::format("{}: {}", json_quoted(word->json), layout_.text_of(piece, "", false))});
      }
      unused.erase(unused.begin(), unused.begin() + static_cast<std::ptrdiff_t>(first));
      missing.erase(missing.begin(), missing.begin() + static_cast<std::ptrdiff_t>(first));
    }
    for (TextChange& change : removal_of_fields(item, unused)) {
      changes.push_back(std::move(change));
    }
    if (!missing.empty()) {
      const std::vector<PartId>& children = syntax_[item.element].children;
      std::optional<std::size_t> before;
      for (std::size_t i = 0; i < children.size(); ++i) {
        const bool stays = std::find(unused.begin(), unused.end(), children[i]) == unused.end();
        const bool type_entry = !syntax_.xml && children[i] == field.element;
        before = syntax_.xml ? (stays ? std::optional(i) : before)
                             : (type_entry ? std::optional(i) : before);
      }
      if (!syntax_.xml && !before && !children.empty()) {
        before = children.size() - 1;
      }
      changes.push_back(joined(item.element, before, missing).change);
    }
    return merged(std::move(changes));
  }

  std::vector<TextChange> mesh_file_changes(const SceneItem& item, const FieldView& shape,
                                            const std::string& wanted,
                                            std::string_view file) const {
    const std::string_view key = syntax_.xml ? "filename" : "meshFile";
    std::optional<TextRange> known;
    PartId entry = no_part;
    if (syntax_.xml) {
      for (const WrittenAttribute& attribute : syntax_.attributes(item.element)) {
        if (attribute.name == key || attribute.name == "meshfile") {
          known = attribute.range;
        }
      }
    } else {
      for (const PartId child : syntax_[item.element].children) {
        if (syntax_.name(child) == key) {
          known = syntax_[child].range();
          entry = child;
        }
      }
    }
    const bool mesh = wanted == ::scenefile::word_of(Shape::mesh);
    if (mesh == known.has_value() || wanted == item.name) {
      return {};
    }
    if (syntax_.xml) {
      const std::array<std::string_view, 2> after{"type", "name"};
      return mesh ? std::vector<TextChange>{layout_.set_attribute(
                        item.element, key, state_.attribute_value(file), after)}
                  : std::vector<TextChange>{{known->from - 1, known->size() + 1, ""}};
    }
    if (!mesh) {
      return removal_of_fields(item, {entry});
    }
    const Piece piece{literal(json_quoted(file)), {}};
    return {
        layout_.insert_entry(item.element, syntax_.index(shape.element) + 1, piece, key).change};
  }

  // Whether a group becomes an instance of a template that has its name.
  bool may_be_instance(const SceneItem& item) const {
    return item.kind == ItemKind::group && (!syntax_.xml || item.children.empty());
  }

  // Why a template or group cannot get this name; empty if it can.
  std::string name_refusal(const SceneItem& item, const std::string& name) const {
    const bool master = item.kind == ItemKind::master;
    const auto items = document_.items();
    const bool taken = std::any_of(items.begin(), items.end(), [&](const SceneItem& other) {
      return other.name == name &&
             (other.kind == ItemKind::master
                  ? master || may_be_instance(item)
                  : master && (other.kind == ItemKind::instance || may_be_instance(other)));
    });
    return master || taken ? why_no_template_name(name, syntax_.xml, taken) : std::string();
  }

  std::vector<TextChange> renamed(const SceneItem& master, const std::string& name) const {
    std::vector<TextChange> changes;
    for (const SceneItem& item : document_.items()) {
      const bool user = item.kind == ItemKind::instance && item.name == master.name;
      if (&item == &master || user) {
        const FieldView field = document_.fields(id_of(item)).front();
        for (TextChange& change : value_changes(item, field, {name})) {
          changes.push_back(std::move(change));
        }
      }
    }
    return changes;
  }

  // Items.

  std::vector<ItemId> siblings_of(ItemId id) const {
    const SceneItem& item = document_[id];
    std::vector<ItemId> siblings;
    for (ItemId other = 0; other < document_.items().size(); ++other) {
      const SceneItem& candidate = document_[other];
      const bool same = syntax_.xml
                            ? candidate.parent == item.parent &&
                                  (item.parent != no_item || candidate.kind == item.kind)
                            : candidate.element != no_part && !is_fixed(candidate) &&
                                  syntax_[candidate.element].parent == syntax_[item.element].parent;
      if (same) {
        siblings.push_back(other);
      }
    }
    return siblings;
  }

  // The element or value that a list contains for an item.
  PartId part_of(const SceneItem& item) const {
    return item.block != no_part && !item.shared ? item.block : item.element;
  }

  std::vector<TextChange> removal_of(const SceneItem& item) const {
    if (syntax_.xml) {
      return {layout_.remove_element(item.range)};
    }
    const std::array<std::size_t, 1> index{syntax_.index(item.element)};
    return layout_.remove_entries(syntax_[item.element].parent, index);
  }

  Insertion inserted_after(const SceneItem& item, const Piece& piece) const {
    const PartId part = part_of(item);
    const PartId parent = syntax_[part].parent;
    return syntax_.xml ? layout_.insert_children(parent, part, {&piece, 1})
                       : layout_.insert_entry(parent, syntax_.index(part) + 1, piece);
  }

  // A piece at the end of a group.
  Insertion appended(const SceneItem& group, const Piece& piece,
                     std::string_view list = "groups") const {
    const SyntaxPart& element = syntax_[group.element];
    if (syntax_.xml) {
      return layout_.insert_children(
          group.element, element.children.empty() ? no_part : element.children.back(), {&piece, 1});
    }
    std::optional<PartId> member;
    for (const PartId child : element.children) {
      if (syntax_.name(child) == list && syntax_[child].type == SyntaxPart::Type::array) {
        member = child;
      }
    }
    if (member) {
      return layout_.insert_entry(*member, syntax_[*member].children.size(), piece);
    }
    // A new list that contains only the piece, directly after its bracket.
    Piece wrapped = piece;
    if (piece.fresh) {
      wrapped.fresh = list_of({*piece.fresh});
    } else {
      wrapped.moved = "[" + piece.moved + "]";
    }
    Insertion change = layout_.insert_entry(group.element, element.children.size(), wrapped, list);
    change.lead = change.change.text.find('{', change.change.text.find('['));
    return change;
  }

  Piece moved_piece(const SceneItem& item) const { return layout_.piece_of(item.range); }

  // With a name or id of its own, moved by `way`.
  Piece copy_of(ItemId id, const glm::dvec3& way) const {
    const SceneItem& item = document_[id];
    const bool master = item.kind == ItemKind::master;
    const bool light = item.kind == ItemKind::light && syntax_.xml;
    std::vector<TextChange> changes;
    for (const FieldView& field : document_.fields(id)) {
      if (field.written && ((master && field.name == "name") || (light && field.name == "id"))) {
        const std::string value = master ? free_name(item.name) : std::to_string(free_id());
        changes = value_changes(item, field, {value});
      }
    }
    const Handle handle{id, glm::dmat4(1), glm::dmat4(1), light};
    if (const Result<Edit> moved =
            way == glm::dvec3(0) ? Edit{} : move_item(document_, handle, way)) {
      changes.insert(changes.end(), moved->changes.begin(), moved->changes.end());
    }
    return changed_piece(item, std::move(changes));
  }

  // An item after changes within it.
  Piece changed_piece(const SceneItem& item, std::vector<TextChange> changes) const {
    Piece piece = moved_piece(item);
    for (TextChange& change : changes) {
      change.at -= item.range.from;
    }
    piece.moved = applied(piece.moved, edit_of(std::move(changes)));
    return piece;
  }

  // With the transforms that keep it where it is in the world or template, if there are such.
  Piece piece_for(ItemId id, ItemId group) const {
    const SceneItem& item = document_[id];
    std::optional<Handle> handle = handle_in_tree(document_, id);
    const std::optional<glm::dmat4> space = tree_from_item(document_, group);
    if (handle && handle->item == id && space && top_of(id) == top_of(group)) {
      if (std::exchange(handle->world_from_space, *space) != *space) {
        if (const Result<Edit> edit = place_item(document_, *handle, handle->world_from_item)) {
          return changed_piece(item, edit->changes);
        }
      }
    }
    return moved_piece(item);
  }

  // A copy beside it; `selected`: the item, or the only one in it, that is to be selected.
  Edit duplicate(ItemId id, ItemId selected, const glm::dvec3& way) const {
    const SceneItem& item = document_[id];
    const bool shares_place = placed_item(document_, id) != id && way != glm::dvec3(0);
    Piece piece = copy_of(id, shares_place ? glm::dvec3(0) : way);
    if (shares_place) {
      const std::string_view list = list_for(item.kind);
      piece.moved = fmt::format(R"({{"translate": [{}, {}, {}], "{}": [{}]}})",
                                number_text(static_cast<float>(way.x)),
                                number_text(static_cast<float>(way.y)),
                                number_text(static_cast<float>(way.z)), list, piece.moved);
    }
    Insertion change = shares_place && list_for(item.kind) != "groups"
                           ? appended(document_[item.parent], piece)
                           : inserted_after(item, piece);
    if (shares_place || id != selected) {
      change.lead = object_in(change, shares_place ? 1 : braces_before(id, selected));
    }
    return edit_of({change.change}, &change.change, change.lead);
  }

  // How many braces open in an item, names included, before one that it contains.
  std::ptrdiff_t braces_before(ItemId id, ItemId inner) const {
    const std::string_view text = state_.text;
    const std::size_t from = document_[id].range.from;
    const std::string_view before = text.substr(from, document_[inner].range.from - from);
    return std::count(before.begin(), before.end(), '{');
  }

  // Where the JSON object after that many braces of an inserted one is.
  static std::size_t object_in(const Insertion& change, std::ptrdiff_t braces = 1) {
    std::size_t at = change.lead;
    for (; braces > 0 && at != std::string::npos; --braces) {
      at = change.change.text.find('{', at + 1);
    }
    return at == std::string::npos ? change.lead : at;
  }

  std::string free_name(const std::string& wanted) const {
    std::set<std::string> taken{"root"};
    for (const SceneItem& item : document_.items()) {
      if (item.kind == ItemKind::master) {
        taken.insert(item.name);
      }
    }
    const std::size_t digits = wanted.find_last_not_of("0123456789");
    const bool numbered =
        digits != wanted.npos && digits + 1 < wanted.size() && wanted[digits] == '-';
    const std::string base = numbered ? wanted.substr(0, digits) : wanted;
    std::string name = wanted;
    for (int n = 2; taken.contains(name); ++n) {
      name = fmt::format("{}-{}", base, n);
    }
    return name;
  }

  bool holds(ItemId outer, ItemId inner) const {
    for (; inner != no_item; inner = document_[inner].parent) {
      if (inner == outer) {
        return true;
      }
    }
    return false;
  }

  ItemId top_of(ItemId id) const {
    while (document_[id].parent != no_item) {
      id = document_[id].parent;
    }
    return id;
  }

  // The last template, as an item, that an item uses, also through others; no_item: none.
  ItemId last_used(ItemId id) const {
    std::set<std::string> names;
    std::vector<ItemId> open{id};
    ItemId last = no_item;
    while (!open.empty()) {
      const ItemId next = open.back();
      open.pop_back();
      const SceneItem& item = document_[next];
      open.insert(open.end(), item.children.begin(), item.children.end());
      if (item.kind != ItemKind::instance || !names.insert(item.name).second) {
        continue;
      }
      for (ItemId master = 0; master < document_.items().size(); ++master) {
        if (document_[master].kind == ItemKind::master && document_[master].name == item.name) {
          last = last == no_item ? master : std::max(last, master);
          open.push_back(master);
        }
      }
    }
    return last;
  }

  Result<Edit> wrap(const SceneItem& item) const {
    const Piece piece = moved_piece(item);
    if (syntax_.xml) {
      return wrap_xml(item, piece);
    }
    const std::string_view list = list_for(item.kind);
    if (list == "groups") {
      return wrap_json_group(item, piece);
    }
    if (syntax_[document_[item.parent].element].type != SyntaxPart::Type::object) {
      return input_error("its group cannot be changed");
    }
    Piece shell;
    shell.moved = fmt::format("{{\"{}\": [{}]}}", list, piece.moved);
    shell.indent = piece.indent;
    std::vector<TextChange> changes = removal_of(item);
    const Insertion change = appended(document_[item.parent], shell);
    std::size_t place = change.change.at + change.lead;
    for (const TextChange& removed : changes) {
      if (removed.at <= change.change.at) {
        place += removed.text.size() - std::min(removed.size, change.change.at - removed.at);
      }
    }
    changes.push_back(change.change);
    Edit edit = edit_of(merged(std::move(changes)));
    edit.select = static_cast<std::uint32_t>(place);
    return edit;
  }

  Edit wrap_xml(const SceneItem& item, const Piece& piece) const {
    const PartId part = part_of(item);
    const Piece shell{element_of("transblock", {},
                                 {element_of("object", {{"type", "tree"}}, {element_of("x", {})})}),
                      {}};
    const Insertion change = layout_.insert_children(syntax_[part].parent, part, {&shell, 1});
    const std::string lines = change.change.text.substr(change.lead);
    const std::size_t at = lines.find("<x/>");
    const std::size_t blank = lines.find_last_not_of(" \t", at - 1) + 1;
    const std::string indent = lines.substr(blank, at - blank);
    return replaced(
        item, lines.substr(0, at) + layout_.text_of(piece, indent, true) + lines.substr(at + 4));
  }

  Edit wrap_json_group(const SceneItem& item, const Piece& piece) const {
    const std::string indent(piece.indent);
    const std::string& moved = piece.moved;
    const std::size_t line = moved.find('\n');
    std::string text;
    if (line == std::string::npos) {
      text = "{\"groups\": [" + moved + "]}";
    } else {
      const std::size_t end = std::min(moved.find_first_not_of(" \t", line + 1), moved.size());
      const std::string deeper = moved.substr(line + 1, end - line - 1);
      const std::string unit = deeper.size() > indent.size() ? deeper.substr(indent.size()) : "  ";
      const std::string& eol = layout_.line_end();
      const std::string inner = indent + unit + unit;
      text = "{" + eol + indent + unit + "\"groups\": [" + eol + inner +
             layout_.text_of(piece, inner, true) + eol + indent + unit + "]" + eol + indent + "}";
    }
    return replaced(item, std::move(text));
  }

  static Edit replaced(const SceneItem& item, std::string text) {
    return {{{item.range.from, item.range.size(), std::move(text)}}, item.range.from};
  }

  // New items.

  Result<Edit> add(std::optional<ItemId> near, const NewItem& what,
                   const std::optional<Viewpoint>& view) const {
    if (what.kind == ItemKind::camera || what.kind == ItemKind::globals) {
      const SceneItem& item = document_[what.kind == ItemKind::globals ? 0 : 1];
      if (item.written) {
        return input_error("the file has one already");
      }
      const Insertion change = new_container(item, {});
      return edit_of({change.change}, &change.change, change.lead);
    }
    const std::optional<ItemId> group = group_for(near);
    if (!syntax_.xml && (!group || !document_[*group].written ||
                         syntax_[document_[*group].element].type != SyntaxPart::Type::object)) {
      return input_error("the scene has no groups; write \"groups\": [] first");
    }
    const std::optional<ItemId> around =
        syntax_.xml && what.kind == ItemKind::light ? std::nullopt : group;
    const glm::dvec3 place = free_place(document_, around, what, view);
    const Values at{number_text(static_cast<float>(place.x)),
                    number_text(static_cast<float>(place.y)),
                    number_text(static_cast<float>(place.z))};
    const bool moved = place != glm::dvec3(0);
    const Insertion change = syntax_.xml ? added_xml(group, what, moved ? at : Values{})
                                         : added_json(*group, what, moved ? at : Values{});
    return edit_of({change.change}, &change.change, syntax_.xml ? change.lead : object_in(change));
  }

  std::optional<ItemId> group_for(std::optional<ItemId> near) const {
    if (near && is_group(document_[*near])) {
      return near;
    }
    const ItemId around = near ? document_[with_place(document_, *near)].parent : no_item;
    if (around != no_item) {
      return around;
    }
    for (ItemId id = 0; id < document_.items().size(); ++id) {
      if (document_[id].kind == ItemKind::root) {
        return id;
      }
    }
    return std::nullopt;
  }

  // `place`: the translation, or the position of a light; empty: none is needed.
  Insertion added_xml(std::optional<ItemId> group, const NewItem& what, const Values& place) const {
    if (what.kind == ItemKind::light) {
      return added_light(what.name, place);
    }
    Fresh object = element_of("object", {});
    const auto set = [&](std::string_view name, std::string_view value) {
      object.attributes.emplace_back(name, state_.attribute_value(value));
    };
    if (what.kind == ItemKind::primitive) {
      set("type", "primitive");
      set("name", what.name);
      if (what.name == ::scenefile::word_of(Shape::mesh)) {
        set("filename", what.file.empty() ? mesh_field.start : std::string_view(what.file));
      }
      object.children.push_back(fresh_element(word_of(ItemKind::primitive, "ambient"), dim_gray()));
      object.children.push_back(fresh_element(word_of(ItemKind::primitive, "diffuse"), {}));
    } else if (what.kind == ItemKind::group) {
      set("type", "tree");
      set("name", free_name("group"));
    } else {
      set("type", "master");
      set("name", what.name);
    }
    Fresh block = element_of("transblock", {}, {std::move(object)});
    if (!place.empty() && what.kind != ItemKind::group) {
      block.children.insert(block.children.begin(), fresh_element(transform_fields[0], place));
    }
    if (!group) {
      block = element_of("object", {{"type", "tree"}, {"name", "root"}}, {std::move(block)});
    }
    const PartId parent = group ? document_[*group].element : 0;
    const std::vector<PartId>& children = syntax_[parent].children;
    const Piece piece{std::move(block), {}};
    Insertion change =
        layout_.insert_children(parent, children.empty() ? no_part : children.back(), {&piece, 1});
    change.lead = group ? change.lead : change.change.text.find("<transblock");
    return change;
  }

  Insertion added_light(std::string_view type, const Values& place) const {
    std::vector<Fresh> fields;
    for (const FieldWord* const word : ordered_words(ItemKind::light, true)) {
      if (use_of(*word, type).needed) {
        fields.push_back(
            fresh_element(*word, word->kind == ValueKind::choice ? Values{std::string(type)}
                                 : word->kind == ValueKind::id   ? Values{std::to_string(free_id())}
                                 : word->xml == "position"       ? place
                                                                 : Values{}));
      }
    }
    PartId before = no_part;
    for (const PartId child : syntax_[0].children) {
      const std::string name = lower_case(syntax_.name(child));
      if (name == "globaldata" || name == "cameradata" || name == "lightdata") {
        before = child;
      }
    }
    const Piece piece{element_of("lightdata", {}, std::move(fields)), {}};
    return layout_.insert_children(0, before, {&piece, 1});
  }

  Insertion added_json(ItemId group, const NewItem& what, const Values& place) const {
    std::vector<Fresh> members;
    const bool is_placed =
        what.kind != ItemKind::group && what.name != ::scenefile::word_of(LightType::directional);
    if ((is_placed && !place.empty()) || what.kind == ItemKind::instance) {
      members.push_back(member("translate", fresh_entry(transform_fields[0], place)));
    }
    if (what.kind == ItemKind::light) {
      std::vector<Fresh> light;
      for (const FieldWord* const word : ordered_words(ItemKind::light, false)) {
        if (use_of(*word, what.name).needed) {
          light.push_back(member(
              word->json,
              fresh_entry(*word, word->kind == ValueKind::choice ? Values{what.name} : Values{})));
        }
      }
      members.push_back(member("lights", list_of({object_of(std::move(light))})));
    } else if (what.kind == ItemKind::primitive) {
      std::vector<Fresh> shape;
      shape.push_back(member("type", literal(json_quoted(what.name))));
      if (what.name == ::scenefile::word_of(Shape::mesh)) {
        shape.push_back(member(
            "meshFile", literal(json_quoted(what.file.empty() ? mesh_field.start : what.file))));
      }
      shape.push_back(
          member("ambient", fresh_entry(word_of(ItemKind::primitive, "ambient"), dim_gray())));
      shape.push_back(member("diffuse", fresh_entry(word_of(ItemKind::primitive, "diffuse"), {})));
      members.push_back(member("primitives", list_of({object_of(std::move(shape))})));
    } else if (what.kind == ItemKind::group) {
      members.push_back(
          member("groups", list_of({})));  // a group with only a name would be an instance
    } else {
      members.push_back(member(
          "groups", list_of({object_of({member("name", literal(json_quoted(what.name)))})})));
    }
    return appended(document_[group], {object_of(std::move(members)), {}});
  }

  const Layout& layout() const { return layout_; }

  std::string_view name_in_block(PartId child) const {
    return child_name(state_, reader_.context, child);
  }

 private:
  const Document& document_;
  const Document::State& state_;
  const Syntax& syntax_;
  Layout layout_;
  SilentReader reader_;
};

Error not_shared() {
  return input_error(
      "several objects share its transblock; give each a transblock of its own first");
}

std::string users_text(std::size_t count) {
  return count == 1 ? "once" : fmt::format("{} times", count);
}

}  // namespace

// Values.

Result<Edit> set_values(const Document& document, ItemId item, const FieldView& field,
                        std::span<const std::optional<std::string>> typed) {
  Values values(field.parts.size());
  for (std::size_t i = 0; i < std::min(values.size(), typed.size()); ++i) {
    if (typed[i]) {
      Result<std::string> value = parse_value(field, i, *typed[i]);
      if (!value) {
        return value.error();
      }
      values[i] = *std::move(value);
    }
  }
  if (std::all_of(values.begin(), values.end(), [](const auto& value) { return !value; })) {
    return Edit{};
  }
  return Editor(document).set(
      item, field, values,
      typed.size() > values.size() && typed.back() ? *typed.back() : std::string(mesh_field.start));
}

Result<Edit> set_value(const Document& document, ItemId item, const FieldView& field,
                       std::size_t part, std::string_view typed) {
  Values values(field.parts.size());
  values[part] = typed;
  return set_values(document, item, field, values);
}

Result<Edit> set_light_type(const Document& document, ItemId item, const FieldView& field,
                            std::string_view type, std::span<const FieldView> known) {
  const Result<std::string> value = parse_value(field, 0, type);
  if (!value) {
    return value.error();
  }
  return edit_of(Editor(document).retyped(document[item], field, *value, known));
}

Result<Edit> remove_value(const Document& document, ItemId item, const FieldView& field) {
  if (!field.written) {
    return input_error("the file does not give this value");
  }
  return Editor(document).unset(document[item], field);
}

Result<Edit> add_transform(const Document& document, ItemId id, std::string_view word,
                           std::span<const double> numbers, std::optional<std::size_t> before) {
  const SceneItem& item = document[id];
  const Syntax& syntax = document.state().syntax;
  const auto* const spec = std::find_if(std::begin(transform_fields), std::end(transform_fields),
                                        [&](const FieldWord& some) { return some.xml == word; });
  if (spec == std::end(transform_fields)) {
    return input_error(fmt::format("{} is not a transform", quoted(word)));
  }
  Values values;
  for (const double number : numbers) {
    values.emplace_back(number_text(static_cast<float>(number)));
  }
  const Editor editor(document);
  if (!document.is_xml()) {
    for (const FieldView& field : document.fields(id)) {
      if (field.name == word && field.transform) {
        if (field.written) {
          return input_error(fmt::format("the group has a {} already; change its values", word));
        }
        values.resize(field.parts.size());
        return edit_of(editor.value_changes(item, field, values));
      }
    }
    return input_error("only groups have transforms; put it into a group first");
  }
  if (item.block == no_part) {
    return input_error(
        "the object has no transblock; put <transblock> and </transblock> around it");
  }
  const std::vector<PartId>& children = syntax[item.block].children;
  const PartId object = item.element == no_part ? no_part : item.element;
  std::size_t index = object == no_part ? children.size() : syntax.index(object);
  std::size_t seen = 0;
  for (std::size_t i = 0; before && i < index; ++i) {
    if (is_transform(editor.name_in_block(children[i]))) {
      index = seen++ == *before ? i : index;
    }
  }
  const Piece piece{editor.fresh_element(*spec, values), {}};
  return edit_of(
      {editor.layout()
           .insert_children(item.block, index == 0 ? no_part : children[index - 1], {&piece, 1})
           .change});
}

Result<Edit> move_transform(const Document& document, ItemId item, const FieldView& field,
                            int step) {
  if (!document.is_xml()) {
    return input_error("JSON applies scale, rotate and translate always in this order");
  }
  std::vector<TextRange> places;
  for (const FieldView& other : document.fields(item)) {
    if (other.transform && other.written) {
      places.push_back(other.place);
    }
  }
  const auto own = std::find(places.begin(), places.end(), field.place);
  const auto at = (own - places.begin()) + step;
  if (own == places.end() || at < 0 || at >= static_cast<std::ptrdiff_t>(places.size())) {
    return input_error(step < 0 ? "it is the first transform" : "it is the last transform");
  }
  const TextRange other = places[static_cast<std::size_t>(at)];
  const std::string& text = document.text();
  return edit_of({{own->from, own->size(), text.substr(other.from, other.size())},
                  {other.from, other.size(), text.substr(own->from, own->size())}});
}

namespace {

// Whether two directions are equal up to the float precision of distant points.
bool same_direction(const glm::vec3& a, const glm::vec3& b) {
  return glm::length(glm::normalize(glm::dvec3(a)) - glm::normalize(glm::dvec3(b))) < 1e-4;
}

// Whether the edited text is the same scene with the new camera.
bool is_as_wanted(const Document& document, const Edit& edit, const Camera& camera) {
  Diagnostics found(document.options().limits);
  Scene after = read_scene(applied(document.text(), edit), document.options(), found);
  if (!after.camera || after.camera->position != camera.position || after.camera->up != camera.up ||
      after.camera->height_angle_deg != camera.height_angle_deg ||
      !same_direction(after.camera->look, camera.look)) {
    return false;
  }
  Scene before = document.scene();
  const Camera old = before.camera.value_or(Camera{});
  if (after.camera->aperture != old.aperture || after.camera->focal_length != old.focal_length) {
    return false;
  }
  after.camera.reset();
  before.camera.reset();
  return after == before;
}

}  // namespace

Result<Edit> set_camera(const Document& document, const Camera& camera) {
  constexpr ItemId camera_item = 1;
  const SceneItem& item = document[camera_item];
  const Editor editor(document);
  const std::vector<FieldView> fields = document.fields(camera_item);
  const bool has_focus = std::any_of(fields.begin(), fields.end(), [](const FieldView& field) {
    return field.name == "focus" && field.written;
  });
  const Camera defaults;
  std::vector<TextChange> changes;
  std::vector<std::pair<const FieldWord*, Values>> fresh;
  // `spelled`: how changed numbers are written.
  const auto set = [&](const FieldView& field, std::span<const float> numbers,
                       std::span<const float> assumed, std::span<const float> spelled = {}) {
    Values values(numbers.size());
    bool differs = false;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const ParsedNumber old = parse_number(field.parts[i].value);
      const bool same = field.parts[i].written && old.error == NumberError::none &&
                        static_cast<float>(old.value) == numbers[i];
      differs = differs || numbers[i] != assumed[i];
      if (!same) {
        values[i] = number_text(spelled.empty() ? numbers[i] : spelled[i]);
      }
    }
    if (field.written) {
      for (TextChange& change : editor.value_changes(item, field, values)) {
        changes.push_back(std::move(change));
      }
    } else if (differs || !item.written) {
      fresh.push_back({&editor.word_of(item.kind, field.name), std::move(values)});
    }
  };
  // The sum of two floats may have more digits than they have.
  const glm::vec3 focus = camera.position + camera.look;
  const glm::dvec3 sum = glm::dvec3(camera.position) + glm::dvec3(camera.look);
  const float size = std::max(glm::length(camera.position), glm::length(camera.look));
  const double step = std::pow(10.0, std::floor(std::log10(std::max(double{size}, 1e-30))) - 5);
  const glm::vec3 rounded = glm::round(sum / step) * step;
  for (const FieldView& field : fields) {
    if (field.title == row_of(camera_rows, Field::position).words.title) {
      set(field, {&camera.position.x, 3}, {&defaults.position.x, 3});
    } else if (field.name == "look" && (field.written || !has_focus)) {
      set(field, {&camera.look.x, 3}, {&defaults.look.x, 3});
    } else if (field.name == "focus" && field.written) {
      set(field, {&focus.x, 3}, {&focus.x, 3}, {&rounded.x, 3});
    } else if (field.name == "up") {
      set(field, {&camera.up.x, 3}, {&defaults.up.x, 3});
    } else if (field.title == row_of(camera_rows, Field::height_angle_deg).words.title) {
      set(field, {&camera.height_angle_deg, 1}, {&defaults.height_angle_deg, 1});
    }
  }
  if (!fresh.empty()) {
    for (TextChange& change : editor.insert_fields(item, fresh)) {
      changes.push_back(std::move(change));
    }
  }
  Edit edit = edit_of(std::move(changes));
  if (!fits(edit, document.text().size()) || !is_as_wanted(document, edit, camera)) {
    return input_error(
        "the camera of this file cannot be changed without changing more; "
        "\"scenefile convert\" writes it cleanly");
  }
  return edit;
}

// Items.

std::vector<NewItem> kinds_to_add(const Document& document, std::optional<ItemId> near) {
  std::vector<NewItem> kinds;
  for (const std::string_view type : light_words) {
    kinds.push_back({ItemKind::light, std::string(type)});
  }
  for (const std::string_view shape : shape_words) {
    kinds.push_back({ItemKind::primitive, std::string(shape)});
  }
  kinds.push_back({ItemKind::group});
  const std::optional<ItemId> group = Editor(document).group_for(near);
  for (std::string& name : document.templates_for(group.value_or(no_item))) {
    kinds.push_back({ItemKind::instance, std::move(name)});
  }
  for (const ItemId id : {0U, 1U}) {
    if (!document[id].written) {
      kinds.push_back({document[id].kind});
    }
  }
  return kinds;
}

Result<Edit> add_item(const Document& document, std::optional<ItemId> near, const NewItem& what,
                      const std::optional<Viewpoint>& view) {
  const std::vector<NewItem> kinds = kinds_to_add(document, near);
  if (std::find(kinds.begin(), kinds.end(), NewItem{what.kind, what.name}) == kinds.end()) {
    return input_error(what.kind == ItemKind::instance
                           ? fmt::format("the template {} is not declared before this group; move "
                                         "the template up or add the instance elsewhere",
                                         quoted(what.name))
                           : "this cannot be added here");
  }
  return Editor(document).add(near, what, view);
}

Result<Edit> remove_item(const Document& document, ItemId selected) {
  const ItemId id = with_place(document, selected);
  const SceneItem& item = document[id];
  if (is_fixed(item)) {
    return input_error("every scene needs it");
  }
  const auto all = document.items();
  const auto users = std::count_if(all.begin(), all.end(), [&](const SceneItem& other) {
    return item.kind == ItemKind::master && other.kind == ItemKind::instance &&
           other.name == item.name;
  });
  if (users > 0) {
    return input_error(fmt::format("it is used {}; remove its instances first",
                                   users_text(static_cast<std::size_t>(users))));
  }
  const Editor editor(document);
  const std::vector<ItemId> siblings = editor.siblings_of(id);
  const auto own = std::find(siblings.begin(), siblings.end(), id);
  Edit edit = edit_of(editor.removal_of(item));
  const ItemId next = own != siblings.end() && own + 1 != siblings.end() ? own[1]
                      : own != siblings.end() && own != siblings.begin() ? own[-1]
                                                                         : item.parent;
  if (next != no_item) {
    edit.select = moved(document[next].range.from, edit);
  }
  return edit;
}

Result<Edit> duplicate_item(const Document& document, ItemId selected,
                            const std::optional<Viewpoint>& view) {
  const ItemId id = with_place(document, selected);
  if (is_fixed(document[id])) {
    return input_error("a scene has only one");
  }
  if (document[id].shared) {
    return not_shared();
  }
  return Editor(document).duplicate(id, selected, way_beside(document, id, view));
}

std::optional<ItemId> neighbor_of(const Document& document, ItemId selected, int step) {
  const ItemId id = with_place(document, selected);
  const SceneItem& item = document[id];
  if (is_fixed(item) || item.shared) {
    return std::nullopt;
  }
  const std::vector<ItemId> siblings = Editor(document).siblings_of(id);
  const auto at = (std::find(siblings.begin(), siblings.end(), id) - siblings.begin()) + step;
  if (at < 0 || at >= static_cast<std::ptrdiff_t>(siblings.size())) {
    return std::nullopt;
  }
  const ItemId other = siblings[static_cast<std::size_t>(at)];
  return document[other].shared ? std::nullopt : std::optional(other);
}

Result<Edit> reorder_item(const Document& document, ItemId selected, int step) {
  const ItemId id = with_place(document, selected);
  const std::optional<ItemId> other = neighbor_of(document, id, step);
  if (!other) {
    return document[id].shared
               ? not_shared()
               : input_error(step < 0 ? "nothing is before it" : "nothing is after it");
  }
  const TextRange own = document.with_comments(id);
  const TextRange there = document.with_comments(*other);
  const std::string& text = document.text();
  const TextChange put{there.from, there.size(), text.substr(own.from, own.size())};
  const TextChange back{own.from, own.size(), text.substr(there.from, there.size())};
  return edit_of({put, back}, &put, document[selected].range.from - own.from);
}

std::vector<ItemId> targets_for(const Document& document, ItemId selected) {
  const ItemId id = with_place(document, selected);
  const SceneItem& item = document[id];
  if (is_fixed(item) || item.kind == ItemKind::master || item.shared ||
      (document.is_xml() && item.kind == ItemKind::light) || placed_item(document, id) != id) {
    return {};
  }
  const Editor editor(document);
  const ItemId used = editor.last_used(id);
  std::vector<ItemId> targets;
  for (ItemId target = 0; target < document.items().size(); ++target) {
    const SceneItem& group = document[target];
    const ItemId top = editor.top_of(target);
    // A template is declared before its first use.
    const bool later = document[top].kind != ItemKind::master || used == no_item || top > used;
    if (is_group(group) && group.written && target != item.parent && !editor.holds(id, target) &&
        later) {
      targets.push_back(target);
    }
  }
  return targets;
}

std::optional<ItemId> group_to_enter(const Document& document, ItemId selected) {
  const ItemId id = with_place(document, selected);
  const std::vector<ItemId> targets = targets_for(document, id);
  std::optional<ItemId> found;
  for (const ItemId target : targets) {
    const SceneItem& group = document[target];
    const bool is_place =
        group.children.size() == 1 && with_place(document, group.children[0]) == target;
    const bool before = group.range.from < document[id].range.from;
    if (group.parent == document[id].parent && group.kind == ItemKind::group && !is_place &&
        (before || !found)) {
      found = target;
    }
  }
  return found;
}

std::optional<ItemId> group_outside(const Document& document, ItemId selected) {
  const ItemId parent = document[with_place(document, selected)].parent;
  const ItemId outside = parent == no_item ? no_item : document[parent].parent;
  return outside == no_item ? std::nullopt : std::optional(outside);
}

Result<Edit> move_into(const Document& document, ItemId selected, ItemId target) {
  const ItemId id = with_place(document, selected);
  const std::vector<ItemId> targets = targets_for(document, id);
  const SceneItem& item = document[id];
  if (item.shared) {
    return not_shared();
  }
  if (std::find(targets.begin(), targets.end(), target) == targets.end()) {
    return input_error(target == item.parent ? "it is in that group already"
                       : placed_item(document, id) != id
                           ? "it shares its group with others; put it into a new group first"
                           : "it cannot be in that group: choose a group that is not part of it, "
                             "and that comes after the templates it uses");
  }
  const Editor editor(document);
  Insertion change =
      editor.appended(document[target], editor.piece_for(id, target), list_for(item.kind));
  if (id != selected) {
    change.lead = Editor::object_in(change, editor.braces_before(id, selected));
  }
  std::vector<TextChange> changes = editor.removal_of(item);
  changes.push_back(change.change);
  return edit_of(std::move(changes), &change.change, change.lead);
}

Result<Edit> wrap_in_group(const Document& document, ItemId selected) {
  const SceneItem& item = document[with_place(document, selected)];
  if (is_fixed(item) || item.kind == ItemKind::master ||
      (document.is_xml() && item.kind == ItemKind::light)) {
    return input_error("only objects can be put into a group");
  }
  if (item.shared) {
    return not_shared();
  }
  return Editor(document).wrap(item);
}

}  // namespace scenefile
