// The text of the scene for the page's panels and editor: what it consists of, its edits, and what
// can be written where. A module of its own, without workers: the page calls it while the text is
// shown. Offsets are those of JavaScript: UTF-16 units.
//  All functions answer in JSON, `{"error": ...}` if something is not possible. They return the
// first byte, and page_edit_answer_size() the length; the answer is valid until the next call.
// Items and fields are indices into what page_edit_open() and page_edit_fields() answered.

#include "answer.h"
#include "scenefile/edit/edits.h"
#include "scenefile/lsp/completion.h"
#include "scenefile/lsp/text_lines.h"
#include "scenefile/scene/vocabulary_words.h"

#include <algorithm>

namespace scenefile {

namespace {

struct Editing {
  std::string answer;
  std::optional<Document> document;
  Utf16Offsets units;
};

Editing& editing() {
  static Editing instance;
  return instance;
}

const Document& open_document() {
  return *editing().document;
}

// `work` writes the members of the answer, or returns why there are none.
template <typename Work>
const char* answer_with(const Work& work) {
  editing().answer = answer_of(
      [&] {
        Json json;
        json.begin_object();
        const std::optional<Error> error = work(json);
        json.end_object();
        return error ? error_json(error->text) : json.text();
      },
      [] {});
  return editing().answer.c_str();
}

std::string_view word_of_kind(ItemKind kind) {
  constexpr std::string_view words[] = {"globals", "camera",    "light",    "root",   "template",
                                        "group",   "primitive", "instance", "ignored"};
  return words[static_cast<std::size_t>(kind)];
}

// What the format says about a field.
std::string_view about_field(const SceneItem& item, std::string_view name) {
  if (open_document().is_xml()) {
    if (const ElementWord* const element = find_element(name)) {
      return element->about;
    }
    const AttributeWord* const attribute = find_attribute(*find_element("object"), name);
    return attribute != nullptr ? attribute->about : std::string_view();
  }
  const std::string_view object = item.kind == ItemKind::globals     ? "globalData"
                                  : item.kind == ItemKind::camera    ? "cameraData"
                                  : item.kind == ItemKind::light     ? "light"
                                  : item.kind == ItemKind::primitive ? "primitive"
                                                                     : "group";
  const KeyWord* const key = find_key(*find_object(object), name);
  return key != nullptr ? key->about : std::string_view();
}

void add_part(Json& json, const FieldPart& part) {
  json.begin_object();
  json.add("name", part.name);
  json.add("number", part.is_number);
  json.add("value", part.value);
  json.add("written", part.written);
  json.end_object();
}

void add_field(Json& json, const SceneItem& item, const FieldView& field) {
  json.begin_object();
  json.add("name", field.name);
  json.add("title", field.title);
  json.add("about", about_field(item, field.name));
  json.add("kind", word_of(field.kind));
  json.begin_array("parts");
  for (const FieldPart& part : field.parts) {
    add_part(json, part);
  }
  json.end_array();
  json.begin_array("choices");
  for (const std::string& choice : field.choices) {
    json.value(choice);
  }
  json.end_array();
  json.add("written", field.written);
  json.add("needed", field.needed);
  json.add("effective", field.effective);
  json.add("transform", field.transform);
  json.end_object();
}

std::optional<Error> add_edit(Json& json, const Result<Edit>& edit) {
  if (!edit) {
    return edit.error();
  }
  const Editing& e = editing();
  json.begin_array("changes");
  for (const TextChange& change : edit->changes) {
    json.begin_object();
    json.add("from", e.units.unit(change.at));
    json.add("to", e.units.unit(change.at + change.size));
    json.add("insert", change.text);
    json.end_object();
  }
  json.end_array();
  if (edit->select) {
    const std::string text = applied(e.document->text(), *edit);
    json.add("select", Utf16Offsets(text).unit(*edit->select));
  }
  return std::nullopt;
}

template <typename Make>
const char* answer_edit(const Make& make) {
  return answer_with([&](Json& json) { return add_edit(json, make(open_document())); });
}

// Why something cannot be done, if it cannot.
void add_obstacle(Json& json, std::string_view name, const Result<Edit>& edit) {
  if (!edit) {
    json.add(name, edit.error().text);
  }
}

void add_matrix(Json& json, std::string_view name, const glm::dmat4& m) {
  json.begin_array(name);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      json.value(m[column][row]);
    }
  }
  json.end_array();
}

const char* answer_handle_edit(ItemId item, const auto& make) {
  return answer_edit([&](const Document& document) -> Result<Edit> {
    const std::optional<Handle> handle = handle_of(document, item);
    return handle ? make(document, *handle) : Error{"nothing can move it"};
  });
}

std::optional<ItemId> near_item(int item) {
  return item < 0 ? std::nullopt : std::optional(static_cast<ItemId>(item));
}

}  // namespace

extern "C" {

std::size_t page_edit_answer_size() {
  return editing().answer.size();
}

/// Opens a text for the functions below, and answers with its items.
const char* page_edit_open(const char* text, std::size_t size, int compat_course) {
  Editing& e = editing();
  e.document.reset();
  return answer_with([&](Json& json) -> std::optional<Error> {
    ReadOptions options;
    options.compat_course = compat_course != 0;
    Result<Document> document = Document::open(std::string(text, size), options);
    if (!document) {
      return document.error();
    }
    e.document = std::move(*document);
    e.units = Utf16Offsets(e.document->text());
    json.add("xml", e.document->is_xml());
    json.begin_array("items");
    for (const SceneItem& item : e.document->items()) {
      json.begin_object();
      json.add("kind", word_of_kind(item.kind));
      json.add("name", item.name);
      json.add("written", item.written);
      json.add("from", e.units.unit(item.range.from));
      json.add("to", e.units.unit(item.range.to));
      json.add("parent", item.parent == no_item ? -1 : static_cast<int>(item.parent));
      json.end_object();
    }
    json.end_array();
    return std::nullopt;
  });
}

/// The innermost item at an offset.
const char* page_edit_at(std::size_t offset) {
  return answer_with([&](Json& json) -> std::optional<Error> {
    const auto at = static_cast<std::uint32_t>(editing().units.byte(offset));
    if (const std::optional<ItemId> item = open_document().item_at(at)) {
      json.add("item", *item);
    }
    return std::nullopt;
  });
}

const char* page_edit_fields(std::size_t item) {
  return answer_with([&](Json& json) -> std::optional<Error> {
    const Document& document = open_document();
    json.begin_array("fields");
    for (const FieldView& field : document.fields(static_cast<ItemId>(item))) {
      add_field(json, document[static_cast<ItemId>(item)], field);
    }
    json.end_array();
    return std::nullopt;
  });
}

/// What can be done with an item, and if not, why; -1: what can be added without one.
const char* page_edit_choices(int item) {
  return answer_with([&](Json& json) -> std::optional<Error> {
    const Document& document = open_document();
    json.begin_array("add");
    for (const NewItem& kind : kinds_to_add(document, near_item(item))) {
      json.begin_object();
      json.add("kind", word_of_kind(kind.kind));
      json.add("name", kind.name);
      json.end_object();
    }
    json.end_array();
    json.begin_array("targets");
    if (item >= 0) {
      for (const ItemId target : targets_for(document, static_cast<ItemId>(item))) {
        json.value(target);
      }
    }
    json.end_array();
    if (item >= 0) {
      const auto id = static_cast<ItemId>(item);
      json.add("before", neighbor_of(document, id, -1).has_value());
      json.add("after", neighbor_of(document, id, 1).has_value());
      add_obstacle(json, "not_duplicated", duplicate_item(document, id));
      add_obstacle(json, "not_removed", remove_item(document, id));
      add_obstacle(json, "not_wrapped", wrap_in_group(document, id));
    }
    return std::nullopt;
  });
}

/// Sets parts of a field. `values`: for each part = and its text, or nothing to leave it as it is,
/// and a zero byte.
const char* page_edit_set(std::size_t item, std::size_t field, const char* values,
                          std::size_t size) {
  return answer_edit([&](const Document& document) {
    std::vector<std::optional<std::string>> parts;
    std::string_view rest(values, size);
    while (!rest.empty()) {
      const std::string_view part = rest.substr(0, rest.find('\0'));
      parts.push_back(part.empty() ? std::nullopt : std::optional(std::string(part.substr(1))));
      rest.remove_prefix(part.size() + 1);
    }
    const auto id = static_cast<ItemId>(item);
    return set_values(document, id, document.fields(id).at(field), parts);
  });
}

const char* page_edit_unset(std::size_t item, std::size_t field) {
  return answer_edit([&](const Document& document) {
    const auto id = static_cast<ItemId>(item);
    return remove_value(document, id, document.fields(id).at(field));
  });
}

const char* page_edit_add_transform(std::size_t item, const char* word) {
  return answer_edit([&](const Document& document) {
    return add_transform(document, static_cast<ItemId>(item), word);
  });
}

const char* page_edit_move_transform(std::size_t item, std::size_t field, int step) {
  return answer_edit([&](const Document& document) {
    const auto id = static_cast<ItemId>(item);
    return move_transform(document, id, document.fields(id).at(field), step);
  });
}

/// Adds the nth kind of page_edit_choices() beside an item; -1: without one.
const char* page_edit_add(int near, std::size_t kind) {
  return answer_edit([&](const Document& document) {
    return add_item(document, near_item(near), kinds_to_add(document, near_item(near)).at(kind));
  });
}

const char* page_edit_remove(std::size_t item) {
  return answer_edit(
      [&](const Document& document) { return remove_item(document, static_cast<ItemId>(item)); });
}

const char* page_edit_duplicate(std::size_t item) {
  return answer_edit([&](const Document& document) {
    return duplicate_item(document, static_cast<ItemId>(item));
  });
}

const char* page_edit_wrap(std::size_t item) {
  return answer_edit(
      [&](const Document& document) { return wrap_in_group(document, static_cast<ItemId>(item)); });
}

const char* page_edit_reorder(std::size_t item, int step) {
  return answer_edit([&](const Document& document) {
    return reorder_item(document, static_cast<ItemId>(item), step);
  });
}

const char* page_edit_move_into(std::size_t item, std::size_t group) {
  return answer_edit([&](const Document& document) {
    return move_into(document, static_cast<ItemId>(item), static_cast<ItemId>(group));
  });
}

/// How an item can be moved; matrices are row by row. Without members if it cannot.
const char* page_edit_handle(std::size_t item) {
  return answer_with([&](Json& json) -> std::optional<Error> {
    if (const auto handle = handle_of(open_document(), static_cast<ItemId>(item))) {
      json.add("light", handle->is_light);
      add_matrix(json, "space", handle->world_from_space);
      add_matrix(json, "world", handle->world_from_item);
    }
    return std::nullopt;
  });
}

const char* page_edit_move(std::size_t item, double x, double y, double z, double step) {
  return answer_handle_edit(static_cast<ItemId>(item), [&](const Document& d, const Handle& h) {
    return move_item(d, h, {x, y, z}, step);
  });
}

const char* page_edit_turn(std::size_t item, int axis, double degrees) {
  return answer_handle_edit(static_cast<ItemId>(item), [&](const Document& d, const Handle& h) {
    return turn_item(d, h, axis, degrees);
  });
}

const char* page_edit_scale(std::size_t item, int axis, double factor) {
  return answer_handle_edit(static_cast<ItemId>(item), [&](const Document& d, const Handle& h) {
    return scale_item(d, h, axis, factor);
  });
}

/// What can be written at an offset of any text.
const char* page_edit_complete(const char* text, std::size_t size, std::size_t offset) {
  return answer_with([&](Json& json) -> std::optional<Error> {
    constexpr std::string_view kinds[] = {"element", "attribute", "value"};
    const Utf16Offsets units({text, size});
    const Completion found = complete({text, size}, units.byte(offset));
    json.add("from", units.unit(found.from));
    json.add("to", units.unit(found.to));
    json.begin_array("items");
    for (const CompletionItem& item : found.items) {
      json.begin_object();
      json.add("label", item.label);
      json.add("kind", kinds[static_cast<std::size_t>(item.kind)]);
      json.add("about", item.about);
      json.add("insert", item.text);
      json.end_object();
    }
    json.end_array();
    return std::nullopt;
  });
}

/// What the word at an offset means. Without members if it is none of the format.
const char* page_edit_describe(const char* text, std::size_t size, std::size_t offset) {
  return answer_with([&](Json& json) -> std::optional<Error> {
    const Utf16Offsets units({text, size});
    if (const std::optional<WordMeaning> word = describe({text, size}, units.byte(offset))) {
      json.add("from", units.unit(word->from));
      json.add("to", units.unit(word->to));
      json.add("about", word->about);
    }
    return std::nullopt;
  });
}
}

}  // namespace scenefile
