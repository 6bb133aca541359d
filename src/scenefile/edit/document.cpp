#include "scenefile/edit/document.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/number.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/edit/document_state.h"
#include "scenefile/edit/layout.h"
#include "scenefile/format/json_fields.h"
#include "scenefile/format/scene_text.h"
#include "scenefile/format/write_text.h"
#include "scenefile/format/xml_blocks.h"
#include "scenefile/format/xml_reader.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace scenefile {

namespace {

constexpr auto names_in_globals = names_of<count_names(global_rows)>(global_rows);
constexpr auto names_in_camera = names_of<count_names(camera_rows)>(camera_rows);
constexpr auto names_in_light = names_of<count_names(light_rows)>(light_rows);
constexpr auto names_in_primitive = names_of<count_names(material_rows)>(material_rows);

// The row of a child element: its name in the vocabulary; empty if the reader does not use it.
template <typename Owner, std::size_t N, std::size_t Count>
std::string_view row_name(const XmlContext& context, const XmlTag& tag,
                          const ValueRow<Owner> (&rows)[N],
                          const std::array<FieldName, Count>& names, std::string_view block) {
  const std::optional<std::size_t> row = find_field(context, tag, names, block);
  return row ? rows[*row].xml : std::string_view();
}

std::string_view known_name(const XmlContext& context, const XmlTag& tag, ItemKind kind) {
  switch (kind) {
    case ItemKind::globals:
      return row_name(context, tag, global_rows, names_in_globals, "globaldata");
    case ItemKind::camera:
      return row_name(context, tag, camera_rows, names_in_camera, "cameradata");
    case ItemKind::light:
      return row_name(context, tag, light_rows, names_in_light, "lightdata");
    case ItemKind::primitive:
      return row_name(context, tag, material_rows, names_in_primitive, "object");
    case ItemKind::root:
    case ItemKind::master:
    case ItemKind::group:
    case ItemKind::instance:
    case ItemKind::unread:
      break;
  }
  return {};
}

std::vector<const WrittenAttribute*> attributes_of(const XmlContext& context,
                                                   const ReadTag& element,
                                                   const Signature& signature) {
  std::vector<const WrittenAttribute*> found(signature.parts);
  const std::optional<Parts> parts = find_parts(context, element.tag, signature);
  for (std::size_t i = 0; i < signature.parts; ++i) {
    const XmlAttribute* attribute = parts ? (*parts)[i] : nullptr;
    for (const AttributeForm& form : signature.forms) {
      attribute = attribute == nullptr && !parts ? element.tag.find(form.names[i]) : attribute;
    }
    found[i] = element.written_as(attribute);
  }
  return found;
}

// The fields of one item.
class FieldList {
 public:
  FieldList(const Document& document, ItemId id)
      : document_(document),
        state_(document.state()),
        syntax_(state_.syntax),
        item_(document[id]),
        reader_(state_) {}

  std::vector<FieldView> list() {
    if (syntax_.xml) {
      list_xml();
    } else {
      list_json();
    }
    return std::move(fields_);
  }

 private:
  FieldView& add(const FieldWord& word, PartId element) {
    FieldView& field = fields_.emplace_back();
    field.name = word.name(syntax_.xml);
    field.title = word.title;
    field.kind = word.kind;
    field.needed = is_needed(word.need, syntax_.xml);
    field.element = element;
    field.written = element != no_part;
    const std::vector<std::string_view> names = parts_of(word, syntax_.xml);
    const std::vector<std::string> start = start_of(word);
    const bool texts = word.kind == ValueKind::choice || word.kind == ValueKind::text ||
                       word.kind == ValueKind::file;
    for (std::size_t i = 0; i < names.size(); ++i) {
      FieldPart& part = field.parts.emplace_back();
      part.name = names.size() == 1 ? field.name : names[i];
      part.is_number = !texts && !(word.kind == ValueKind::image && i == 0);
      part.range = part.is_number ? word.range : NumberRange{};
      part.value = start[std::min(i, start.size() - 1)];
    }
    return field;
  }

  void fill(FieldPart& part, TextRange place, std::string value) const {
    part.written = true;
    part.place = place;
    part.value = std::move(value);
  }

  void fill(FieldPart& part, const WrittenAttribute* attribute) const {
    if (attribute != nullptr) {
      fill(part, attribute->value, decoded_value(state_.utf8(syntax_.slice(attribute->value))));
    }
  }

  void judge(FieldView& field) const {
    const std::string_view name = field.name;
    if (item_.kind == ItemKind::light) {
      const LightUse use = light_use(name, item_.name, syntax_.xml);
      field.needed = use.needed;
      field.effective = use.effective;
    }
    if (name == "type" && item_.kind == ItemKind::light) {
      field.choices.assign(light_words.begin(), light_words.end());
    } else if (field.title == shape_field.title) {
      field.choices.assign(shape_words.begin(), shape_words.end());
    }
  }

  // XML.

  void list_xml() {
    switch (item_.kind) {
      case ItemKind::globals:
      case ItemKind::camera:
      case ItemKind::light:
        list_elements();
        break;
      case ItemKind::root:
        break;
      case ItemKind::master:
        own(name_field, "name").needed = true;
        break;
      case ItemKind::group:
        own(name_field, "name");
        list_transforms();
        break;
      case ItemKind::instance:
        own(template_field, "name").needed = true;
        fields_.back().choices = document_.templates_for(item_.parent);
        list_transforms();
        break;
      case ItemKind::unread:
        list_transforms();
        break;
      case ItemKind::primitive:
        list_shape();
        list_transforms();
        list_elements();
        break;
    }
  }

  // A field that is an attribute of the item's element.
  FieldView& own(const FieldWord& word, std::string_view name) {
    const ReadTag tag(state_, item_.element);
    FieldView& field = add(word, no_part);
    const WrittenAttribute* found = nullptr;
    if (const std::optional<ObjectTag> object = read_object_tag(reader_.context, tag.tag)) {
      const std::string_view value = name == "name" ? object->name : object->filename;
      for (const XmlAttribute& attribute : tag.attributes) {  // it may be misspelled
        found = value.data() != nullptr && attribute.value.data() == value.data()
                    ? tag.written_as(&attribute)
                    : found;
      }
    }
    if (found != nullptr) {
      field.written = true;
      field.place = found->range;
      fill(field.parts[0], found);
    }
    judge(field);
    return field;
  }

  void list_shape() {
    own(shape_field, "name");
    const ReadTag tag(state_, item_.element);
    const bool other = tag.tag.find("filename") == nullptr && tag.tag.find("meshfile") != nullptr;
    FieldView& file = own(mesh_field, other ? "meshfile" : "filename");
    file.needed = item_.name == "mesh";
    if (!file.written && !file.needed) {
      fields_.pop_back();
    }
  }

  void list_transforms() {
    if (item_.block == no_part) {
      return;
    }
    for (const PartId child : syntax_[item_.block].children) {
      if (child == item_.element && !state_.options.compat_course) {
        break;  // what follows has no effect
      }
      const std::string_view name = child_name(state_, reader_.context, child);
      for (const FieldWord& word : transform_fields) {
        if (word.xml == name) {
          read_element(word, child).transform = true;
        }
      }
    }
  }

  void list_elements() {
    std::vector<PartId> blocks;
    if (item_.kind == ItemKind::globals) {
      for (const PartId part : syntax_[0].children) {
        if (child_name(state_, reader_.context, part) == "globaldata") {
          blocks.push_back(part);
        }
      }
    } else if (item_.element != no_part) {
      blocks.push_back(item_.element);
    }
    const std::vector<const FieldWord*> words = ordered_words(item_.kind, true);
    std::vector<PartId> elements(words.size(), no_part);
    for (const PartId block : blocks) {
      for (const PartId child : syntax_[block].children) {
        const FieldWord* const word = word_of_child(state_, reader_.context, item_.kind, child);
        const auto found = std::find(words.begin(), words.end(), word);
        if (found != words.end()) {
          elements[static_cast<std::size_t>(found - words.begin())] = child;
        }
      }
    }
    for (std::size_t i = 0; i < words.size(); ++i) {
      judge(read_element(*words[i], elements[i]));
      if (!fields_.back().effective && !fields_.back().written) {
        fields_.pop_back();
      }
    }
  }

  FieldView& read_element(const FieldWord& word, PartId element) {
    FieldView& field = add(word, element);
    if (element == no_part) {
      return field;
    }
    field.place = syntax_[element].range();
    const ReadTag tag(state_, element);
    std::vector<const WrittenAttribute*> found;
    if (word.kind == ValueKind::matrix) {
      const std::vector<PartId>& rows = syntax_[element].children;
      for (std::size_t r = 0; r < std::min<std::size_t>(rows.size(), 4); ++r) {
        const ReadTag row(state_, rows[r]);
        found = attributes_of(reader_.context, row, signature_of(ValueKind::matrix));
        for (std::size_t i = 0; i < 4; ++i) {
          fill(field.parts[4 * r + i], found[i]);
        }
      }
      return field;
    }
    found = field_attributes(reader_.context, tag, word);
    for (std::size_t i = 0; i < found.size(); ++i) {
      fill(field.parts[i], found[i]);
    }
    return field;
  }

  // JSON.

  void list_json() {
    if (item_.kind == ItemKind::root) {
      return;
    }
    find_entries();
    const bool placed = item_.kind == ItemKind::group || item_.kind == ItemKind::master ||
                        item_.kind == ItemKind::instance;
    if (placed) {
      const bool instance = item_.kind == ItemKind::instance;
      FieldView& name = read_entry(instance ? template_field : name_field);
      name.needed = item_.kind != ItemKind::group;
      if (instance) {
        name.choices = document_.templates_for(item_.parent);
      }
      for (const FieldWord& word : transform_fields) {
        read_entry(word).transform = true;
        if (instance && !fields_.back().written) {
          fields_.pop_back();
        } else {
          fields_.back().effective = !instance;
        }
      }
      return;
    }
    for (const FieldWord* const word : ordered_words(item_.kind, false)) {
      FieldView& field = read_entry(*word);
      judge(field);
      const bool other_file = field.name == "meshFile" && item_.name != "mesh";
      field.effective = field.effective && !other_file;
      if (!field.written && !field.effective) {
        fields_.pop_back();
      }
    }
  }

  // The entries of the item under the names that the reader gives them.
  void find_entries() {
    const bool group = words_of(item_.kind).empty();
    std::vector<std::string_view> names;
    for (const FieldWord* const word : ordered_words(item_.kind, false)) {
      names.push_back(word->json);
    }
    if (group) {
      names = {"name", "translate", "rotate", "scale", "matrix", "lights", "primitives", "groups"};
    }
    if (item_.element == no_part || syntax_[item_.element].type != SyntaxPart::Type::object) {
      return;
    }
    Diagnostics found(state_.options.limits);
    const RepairedJson repaired;
    JsonContext context(syntax_.tape, {}, repaired, state_.options.limits, found);
    const JsonVocabulary vocabulary{"", names};
    const JsonFields fields(context, syntax_[item_.element].item, vocabulary);
    for (const PartId child : syntax_[item_.element].children) {
      for (std::size_t i = 0; i < names.size(); ++i) {
        if (fields.key(i) + 1 == syntax_[child].item) {
          entries_.emplace_back(names[i], child);
        }
      }
    }
  }

  FieldView& read_entry(const FieldWord& word) {
    const auto found = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const auto& entry) { return entry.first == word.json; });
    const PartId entry = found == entries_.end() ? no_part : found->second;
    FieldView& field = add(word, entry);
    if (entry == no_part) {
      return field;
    }
    const SyntaxPart& value = syntax_[entry];
    field.place = value.range();
    std::vector<PartId> numbers;
    for (const PartId child : value.children) {
      const std::vector<PartId>& row = syntax_[child].children;
      if (syntax_[child].type == SyntaxPart::Type::array) {
        numbers.insert(numbers.end(), row.begin(), row.end());
      } else {
        numbers.push_back(child);
      }
    }
    if (value.type != SyntaxPart::Type::array) {
      numbers.clear();
      const bool is_vector = field.parts.size() > 1 && field.parts[0].is_number;
      if (!is_vector) {  // a single value is no part of one
        numbers.push_back(entry);
      }
    }
    for (std::size_t i = 0; i < std::min(numbers.size(), field.parts.size()); ++i) {
      const SyntaxPart& part = syntax_[numbers[i]];
      if (part.type == SyntaxPart::Type::array || part.type == SyntaxPart::Type::object) {
        continue;  // not a value
      }
      fill(field.parts[i], part.value(),
           part.type == SyntaxPart::Type::string ? syntax_.tape.string(part.item)
                                                 : std::string(syntax_.slice(part.value())));
    }
    return field;
  }

  const Document& document_;
  const Document::State& state_;
  const Syntax& syntax_;
  const SceneItem& item_;
  SilentReader reader_;
  std::vector<std::pair<std::string_view, PartId>> entries_;  // JSON
  std::vector<FieldView> fields_;
};

// A number that is valid in both dialects.
bool is_json_number(std::string_view text) {
  JsonTape tape;
  return !text.empty() && (is_digit(text[0]) || text[0] == '-') &&
         parse_json(text, 1, tape).fault == JsonFault::none;
}

std::string range_text(const NumberRange& range) {
  const bool low = range.low > -std::numeric_limits<double>::infinity();
  const bool high = range.high < std::numeric_limits<double>::infinity();
  const std::string from =
      fmt::format("{} {}", range.open_low ? "more than" : "at least", range.low);
  const std::string to =
      fmt::format("{} {}", range.open_high ? "less than" : "at most", range.high);
  return low && high ? from + " and " + to : low ? from : to;
}

}  // namespace

// State.

std::string Document::State::utf8(std::string_view bytes) const {
  if (declaration.empty()) {
    return std::string(bytes);
  }
  std::string storage;
  Diagnostics found;
  const std::string whole = declaration + std::string(bytes);
  const std::optional<std::string_view> decoded = decode_text(whole, storage, found);
  return decoded ? std::string(decoded->substr(declaration.size())) : std::string(bytes);
}

std::string Document::State::attribute_value(std::string_view value) const {
  std::string escaped;
  append_xml(escaped, value);
  std::string out;
  for (std::size_t at = 0; at < escaped.size();) {
    const CodePoint c = first_code_point(std::string_view(escaped).substr(at));
    const std::size_t size = std::max<std::size_t>(c.bytes, 1);
    const std::string_view bytes = std::string_view(escaped).substr(at, size);
    if (c.value == '\'') {
      out += "&apos;";
    } else if (c.value < 0x80 || declaration.empty()) {
      out += bytes;
    } else {
      std::string byte;
      for (int i = 0x80; i < 0x100 && byte.empty(); ++i) {
        const std::string one(1, static_cast<char>(i));
        byte = utf8(one) == bytes ? one : "";
      }
      out += !byte.empty() ? byte : fmt::format("&#{};", static_cast<std::uint32_t>(c.value));
    }
    at += size;
  }
  return out;
}

ReadTag::ReadTag(const Document::State& state, PartId element)
    : written(state.syntax.attributes(element)) {
  values.reserve(written.size());
  for (const WrittenAttribute& attribute : written) {
    std::string_view value = state.syntax.slice(attribute.value);
    const bool is_plain = std::all_of(value.begin(), value.end(), [](char c) {
      return c >= ' ' && c != '&' && static_cast<unsigned char>(c) < 0x80;
    });
    if (!is_plain) {
      value = values.emplace_back(decoded_value(state.utf8(value)));
    }
    attributes.push_back({attribute.name, value});
  }
  tag = {state.syntax.name(element), attributes, state.syntax.places[element]};
}

std::vector<const WrittenAttribute*> field_attributes(const XmlContext& context,
                                                      const ReadTag& element,
                                                      const FieldWord& word) {
  if (word.kind == ValueKind::image) {
    return {element.written_as(find_image_file(context, element.tag)),
            element.written_as(find_repeat(context, element.tag, "u")),
            element.written_as(find_repeat(context, element.tag, "v"))};
  }
  return attributes_of(context, element, signature_of(word.kind));
}

const FieldWord* word_of_child(const Document::State& state, const XmlContext& context,
                               ItemKind kind, PartId child) {
  const bool xml = state.syntax.xml;
  std::string decoded;
  std::string_view name = state.syntax.name(child);
  if (xml) {
    const ReadTag tag(state, child);
    name = known_name(context, tag.tag, kind);
  } else if (name.find('\\') != name.npos) {
    decoded = state.syntax.tape.string(state.syntax[child].item - 1);
    name = decoded;
  }
  const std::span<const FieldWord> words = words_of(kind);
  const auto same = [&](const FieldWord& word) { return !name.empty() && word.name(xml) == name; };
  if (const auto found = std::find_if(words.begin(), words.end(), same); found != words.end()) {
    return &*found;
  }
  if (!words.empty()) {
    return nullptr;
  }
  if (name == name_field.json) {
    return kind == ItemKind::instance ? &template_field : &name_field;
  }
  const auto* const found =
      std::find_if(std::begin(transform_fields), std::end(transform_fields), same);
  return found == std::end(transform_fields) ? nullptr : found;
}

// Document.

Result<Document> Document::open(std::string text, const ReadOptions& options) {
  auto state = std::make_shared<State>(
      State{std::move(text), options, {}, {}, Diagnostics(options.limits), {}, {}});
  Result<Syntax> syntax = parse_syntax(state->text, options);
  if (!syntax) {
    return syntax.error();
  }
  state->syntax = *std::move(syntax);
  constexpr std::string_view scenefile = "scenefile";
  const std::string_view outer = state->syntax.xml ? state->syntax.name(0) : scenefile;
  if (!equal_ignoring_case(outer, scenefile) && nearest_name(outer, {&scenefile, 1}).empty()) {
    return input_error(fmt::format(
        "the file is not a scene: it begins with {} instead of <scenefile>", element_text(outer)));
  }
  if (state->text.starts_with("<?xml")) {
    constexpr std::string_view letter = "\xC3\xA9";
    state->declaration = state->text.substr(0, state->text.find("?>") + 2);
    std::string storage;
    Diagnostics found;
    const std::string sample = state->declaration + std::string(letter);
    const auto decoded = decode_text(sample, storage, found);
    if (decoded && decoded->ends_with(letter) && storage.empty()) {
      state->declaration.clear();
    }
  }
  state->scene = read_scene(state->text, options, state->findings);
  find_items(*state);
  Document document;
  document.state_ = std::move(state);
  return document;
}

const std::string& Document::text() const {
  return state_->text;
}
bool Document::is_xml() const {
  return state_->syntax.xml;
}
const ReadOptions& Document::options() const {
  return state_->options;
}
const Scene& Document::scene() const {
  return state_->scene;
}
const Diagnostics& Document::findings() const {
  return state_->findings;
}
std::span<const SceneItem> Document::items() const {
  return state_->items;
}

double number_of(const FieldPart& part) {
  return parse_number(part.value).value;
}

std::optional<ItemId> Document::item_at(std::uint32_t offset) const {
  std::optional<ItemId> best;
  for (ItemId id = 0; id < items().size(); ++id) {
    const TextRange& range = items()[id].range;
    if (items()[id].written && range.from <= offset && offset < range.to &&
        (!best || range.size() <= items()[*best].range.size())) {
      best = id;
    }
  }
  return best;
}

std::optional<ItemId> Document::item_of(Location place) const {
  const Syntax& syntax = state_->syntax;
  const auto before = [](const Location& a, const Location& b) {
    return a.line != b.line ? a.line < b.line : a.column < b.column;
  };
  const auto next = std::upper_bound(syntax.places.begin(), syntax.places.end(), place, before);
  if (next == syntax.places.begin()) {
    return std::nullopt;
  }
  return item_at(syntax[static_cast<PartId>(next - syntax.places.begin() - 1)].from);
}

std::vector<FieldView> Document::fields(ItemId item) const {
  return FieldList(*this, item).list();
}

TextRange Document::with_comments(ItemId id) const {
  const SceneItem& item = items()[id];
  if (!is_xml() || !item.written) {
    return item.range;
  }
  const Syntax& syntax = state_->syntax;
  const PartId part = item.block != no_part && !item.shared ? item.block : item.element;
  const PartId parent = syntax[part].parent;
  return Layout(syntax).with_comments(item.range, parent == no_part ? 0 : syntax[parent].body);
}

std::vector<std::string> Document::templates_for(ItemId group) const {
  std::vector<std::string> names;
  ItemId top = group;
  while (top != no_item && items()[top].parent != no_item) {
    top = items()[top].parent;
  }
  for (ItemId id = 0; id < items().size() && id != top; ++id) {
    if (items()[id].kind == ItemKind::master && !items()[id].name.empty()) {
      names.push_back(items()[id].name);
    }
  }
  if (top != no_item && items()[top].kind == ItemKind::root) {  // which may precede them
    names.clear();
    for (const SceneItem& item : items()) {
      if (item.kind == ItemKind::master && !item.name.empty()) {
        names.push_back(item.name);
      }
    }
  }
  return names;
}

Result<std::string> parse_value(const FieldView& field, std::size_t index, std::string_view typed) {
  const FieldPart& part = field.parts[index];
  const auto refuse = [&](std::string_view why) {
    return input_error(fmt::format(
        "{}{}: {}", field.title, field.parts.size() > 1 ? fmt::format(" {}", part.name) : "", why));
  };
  if (!part.is_number) {
    if (!field.choices.empty() &&
        std::find(field.choices.begin(), field.choices.end(), typed) == field.choices.end()) {
      return refuse(
          fmt::format("{} is not one of {}", quoted(typed), fmt::join(field.choices, ", ")));
    }
    if (typed.empty() && (field.kind == ValueKind::file || field.kind == ValueKind::image)) {
      return refuse("enter the name of a file");
    }
    return std::string(typed);
  }
  const std::size_t first = std::min(typed.find_first_not_of(blanks), typed.size());
  typed = typed.substr(first, typed.find_last_not_of(blanks) + 1 - first);
  const ParsedNumber number = parse_number(typed);
  if (number.error == NumberError::out_of_range) {
    return refuse(fmt::format("{} is too large for a number", quoted(typed)));
  }
  if (number.error != NumberError::none) {
    return refuse(typed.empty() ? "enter a number, such as 1.5"
                                : fmt::format("{} is not a number; write one like 1.5 or -2e3",
                                              quoted(typed)));
  }
  if (!part.range.contains(number.value)) {
    return refuse(fmt::format("{} is out of range: it must be {}", typed, range_text(part.range)));
  }
  if (field.kind == ValueKind::id && number.value != static_cast<int>(number.value)) {
    return refuse(fmt::format("{} is not a whole number", typed));
  }
  return is_json_number(typed) ? std::string(typed) : number_text(static_cast<float>(number.value));
}

}  // namespace scenefile
