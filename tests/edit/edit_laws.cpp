#include "edit_laws.h"

#include "scenefile/base/number.h"
#include "scenefile/format/xml_scanner.h"
#include "scenefile/scene/check.h"
#include "scenefile/scene/prepare.h"

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace scenefile::testing {

namespace {

std::vector<std::string> comments_of(const Document& document) {
  std::vector<std::string> comments;
  if (document.is_xml()) {
    XmlScanner scanner(document.text());
    for (XmlToken token; scanner.next(token);) {
      if (token.kind == XmlTokenKind::comment) {
        std::string comment(token.written);  // whose lines may be indented anew
        std::erase_if(comment, [](char c) { return c == ' ' || c == '\t'; });
        comments.push_back(std::move(comment));
      }
    }
  }
  std::sort(comments.begin(), comments.end());
  return comments;
}

// A comment may be about another item once there are several on its line.
std::string without_comments(std::string text) {
  for (std::size_t at = 0; (at = text.find("<!--", at)) != std::string::npos;) {
    text.erase(at, std::min(text.find("-->", at), text.size() - 3) + 3 - at);
  }
  return text;
}

// The text without white space and without what adding may leave: empty lists and end tags.
std::string dense(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view(" \t\r\n").find(c) == std::string_view::npos) {
      out += c;
    }
  }
  const auto drop = [&](std::string_view what, std::string_view by) {
    for (std::size_t at = 0; (at = out.find(what, at)) != std::string::npos;) {
      out.replace(at, what.size(), by);
    }
  };
  for (const std::string_view list : {"\"lights\":[]", "\"primitives\":[]", "\"groups\":[]"}) {
    drop("," + std::string(list), "");
    drop(list, "");
  }
  drop("/>", ">");
  for (std::size_t at = 0; (at = out.find("</", at)) != std::string::npos;) {
    out.erase(at, out.find('>', at) + 1 - at);
  }
  return out;
}

bool same_node(const Node& a, const Node& b) {
  return a.name == b.name && a.transforms == b.transforms && a.lights == b.lights &&
         a.primitives == b.primitives && a.children == b.children && a.instance_of == b.instance_of;
}

// How many of the nodes, the camera and the global data differ.
std::size_t changed_parts(const Scene& a, const Scene& b) {
  std::size_t count = (a.global == b.global ? 0U : 1U) + (a.camera == b.camera ? 0U : 1U);
  for (std::size_t i = 0; i < std::max(a.nodes.size(), b.nodes.size()); ++i) {
    count += i >= a.nodes.size() || i >= b.nodes.size() || !same_node(a.nodes[i], b.nodes[i]);
  }
  return count;
}

bool has_errors(const Document& document) {
  Diagnostics found(document.options().limits);
  check(document.scene(), document.options().limits, found);
  return document.findings().has_errors() || found.has_errors();
}

class Laws {
 public:
  Laws(std::mt19937& chance, EditCounts& counts) : chance_(chance), counts_(counts) {}

  const std::string& failure() const { return failure_; }

  std::size_t below(std::size_t count) { return count == 0 ? 0 : chance_() % count; }

  void require(bool holds, const std::string& what) {
    if (!holds && failure_.empty()) {
      failure_ = what;
    }
  }

  // What holds for every edit; the document after it.
  std::optional<Document> after(const Document& before, const Result<Edit>& edit,
                                const std::string& what, bool keeps_comments = true) {
    if (!edit) {
      ++counts_["refused"];
      return std::nullopt;
    }
    ++counts_[what.substr(0, what.find(' '))];
    const std::string& text = before.text();
    require(fits(*edit, text.size()), what + ": changes overlap in\n" + text);
    if (!failure_.empty()) {
      return std::nullopt;
    }
    const std::string edited = applied(text, *edit);
    require(applied(edited, inverse(text, *edit)) == text, what + ": undo");
    Result<Document> document = Document::open(edited, before.options());
    if (!document) {
      require(false, what + ": cannot be read again: " + document.error().text + "\n" + edited);
      return std::nullopt;
    }
    require(!keeps_comments || comments_of(*document) == comments_of(before),
            what + ": comments\n" + edited);
    require(!edit->select || *edit->select <= edited.size(), what + ": selection");
    return *std::move(document);
  }

  std::optional<ItemId> item_from(const Document& document, std::optional<std::uint32_t> from) {
    for (ItemId id = 0; from && id < document.items().size(); ++id) {
      if (document[id].written && document[id].range.from == *from && *from > 0) {
        return id;
      }
    }
    return std::nullopt;
  }

  // Another value that the part accepts.
  std::optional<std::string> other_value(const FieldView& field, std::size_t index) {
    const FieldPart& part = field.parts[index];
    if (field.kind == ValueKind::choice) {
      const std::size_t other = below(field.choices.size());
      const bool fine = !field.choices.empty() && field.choices[other] != part.value &&
                        field.choices[other] != "mesh";
      return fine ? std::optional(field.choices[other]) : std::nullopt;
    }
    if (!part.is_number) {
      return fmt::format("n\xC3\xA4me <{}> & \"more'", below(100));
    }
    if (field.kind == ValueKind::matrix && index >= 12) {
      return std::nullopt;
    }
    const double now = parse_number(part.value).value;
    for (const double number : {now + 0.125, now - 0.125, now / 2, 1.0, 0.5}) {
      const auto rounded = static_cast<float>(field.kind == ValueKind::id ? 5 : number);
      if (part.range.contains(rounded) && rounded != 0 && number_text(rounded) != part.value) {
        return number_text(rounded);
      }
    }
    return std::nullopt;
  }

  // All values of all fields, but those of `without`.
  std::vector<std::string> values_of(const Document& document, ItemId item,
                                     std::string_view without, TextRange place) {
    std::vector<std::string> values;
    for (ItemId id = 0; id < document.items().size(); ++id) {
      for (const FieldView& field : document.fields(id)) {
        // Several objects may share their transforms.
        const bool same = field.name == without && (id == item || field.transform) &&
                          (!field.transform || field.place.from == place.from);
        for (const FieldPart& part : field.parts) {
          if (!same && part.written) {
            values.push_back(fmt::format("{} {} {}", id, field.name, part.value));
          }
        }
      }
    }
    return values;
  }

  void set_part(const Document& document, ItemId item, const FieldView& field, std::size_t part) {
    const std::optional<std::string> value = other_value(field, part);
    const bool whole = field.kind == ValueKind::image && !field.parts[0].written && part > 0;
    if (!value || whole) {
      return;
    }
    const std::string what =
        fmt::format("set {} {} part {} to {}", document[item].name, field.name, part, *value);
    const Result<Edit> edit = set_value(document, item, field, part, *value);
    require(bool(edit), what + ": " + error_text(edit));
    const std::optional<Document> edited = after(document, edit, what);
    if (!edited || !failure_.empty()) {
      return;
    }
    // Names may change what groups are, and types which fields there are.
    const bool naming = field.kind == ValueKind::text || field.kind == ValueKind::choice;
    if (naming) {
      return;
    }
    require(edited->items().size() == document.items().size(), what + ": items");
    for (const FieldView& now : edited->fields(item)) {
      const bool same = now.name == field.name &&
                        (!now.transform || !field.written || now.place.from == field.place.from);
      if (same && !(now.transform && document.is_xml() && !field.written)) {
        require(now.parts[part].value == *value,
                fmt::format("{}: is {}\n{}", what, now.parts[part].value, edited->text()));
      }
    }
    if (field.written) {
      require(values_of(document, item, field.name, field.place) ==
                  values_of(*edited, item, field.name, field.place),
              what + ": other values\n" + edited->text());
      require(edit->changes.size() <= 1, what + ": more than one change");
    }
    require(!field.written || changed_parts(document.scene(), edited->scene()) <= 1,
            what + ": more than one part of the scene changed\n" + edited->text());
    if (field.written && field.parts[part].written && !has_errors(document)) {
      const std::vector<FieldView> fields = edited->fields(item);
      const auto same = std::find_if(fields.begin(), fields.end(), [&](const FieldView& now) {
        return now.name == field.name && now.place.from == field.place.from;
      });
      require(same != fields.end(), what + ": field is lost");
      const bool again =
          parse_value(field, part, field.parts[part].value) &&
          *parse_value(field, part, field.parts[part].value) == field.parts[part].value;
      if (failure_.empty() && again) {
        const Result<Edit> back = set_value(*edited, item, *same, part, field.parts[part].value);
        const std::string text = back ? applied(edited->text(), *back) : std::string();
        const bool escaped = document.text().find('&') != std::string::npos;
        require(text == document.text() || (escaped && text.size() != document.text().size()) ||
                    !field.parts[part].is_number,
                what + ": setting it back\n" + text);
      }
    }
  }

  void fields(const Document& document, ItemId item) {
    const std::vector<FieldView> all = document.fields(item);
    for (const FieldView& field : all) {
      const std::size_t part = below(field.parts.size());
      set_part(document, item, field, part);
      if (field.written && below(3) == 0 && field.kind != ValueKind::choice) {
        after(document, remove_value(document, item, field), "unset " + std::string(field.name),
              field.kind != ValueKind::matrix && field.kind != ValueKind::rotation && false);
      }
    }
  }

  void there_and_back(const Document& document, ItemId item) {
    const std::string name =
        fmt::format("{} at {}", document[item].name, document[item].range.from);
    const Result<Edit> copy = duplicate_item(document, item);
    if (const auto copied = after(document, copy, "duplicate " + name, false)) {
      const std::optional<ItemId> found = item_from(*copied, copy->select);
      require(found.has_value(), "duplicate " + name + ": nothing to select\n" + copied->text());
      const Result<Edit> removal = found ? remove_item(*copied, *found) : Result<Edit>(Edit{});
      // The copy of one of several objects of a group in JSON may be in a new list.
      require(removal && (applied(copied->text(), *removal) == document.text() ||
                          (!document.is_xml() &&
                           dense(applied(copied->text(), *removal)) == dense(document.text()))),
              "duplicate " + name + ": removing it\n" + copied->text());
    }
    for (const int step : {-1, 1}) {
      const Result<Edit> edit = reorder_item(document, item, step);
      if (const auto moved = after(document, edit, fmt::format("reorder {} {}", name, step))) {
        const std::optional<ItemId> found = item_from(*moved, edit->select);
        // Of two templates of the same name, only the first counts.
        const bool faulty = has_errors(document);
        require(faulty || found.has_value(), "reorder " + name + ": lost\n" + moved->text());
        const Result<Edit> back =
            found ? reorder_item(*moved, *found, -step) : Result<Edit>(Edit{});
        // A comment takes white space along.
        require(faulty || (back && dense(without_comments(applied(moved->text(), *back))) ==
                                       dense(without_comments(document.text()))),
                "reorder " + name + ": there and back\n" + moved->text());
      }
    }
    const std::vector<NewItem> kinds = kinds_to_add(document, item);
    const NewItem& kind = kinds[below(kinds.size())];
    const Result<Edit> addition = add_item(document, item, kind);
    if (const auto added = after(document, addition, "add " + kind.name + " to " + name)) {
      const std::optional<ItemId> found = item_from(*added, addition->select);
      const bool fixed = kind.kind == ItemKind::camera || kind.kind == ItemKind::globals;
      require(fixed || found.has_value(),
              "add to " + name + ": nothing to select\n" + added->text());
      const auto items = document.items();
      const bool has_root = std::any_of(items.begin(), items.end(), [](const SceneItem& one) {
        return one.kind == ItemKind::root;
      });
      if (found && !fixed && has_root) {
        const Result<Edit> removal = remove_item(*added, *found);
        require(removal && dense(applied(added->text(), *removal)) == dense(document.text()),
                "add " + kind.name + " to " + name + ": removing it\n" + added->text() + "\n=>\n" +
                    (removal ? applied(added->text(), *removal) : removal.error().text));
      }
    }
    after(document, remove_item(document, item), "remove " + name, false);
  }

  void grouping(const Document& document, ItemId item) {
    const std::string name =
        fmt::format("{} at {}", document[item].name, document[item].range.from);
    const bool faulty = has_errors(document);
    const Result<Edit> wrap = wrap_in_group(document, item);
    if (const auto wrapped = after(document, wrap, "wrap " + name)) {
      const std::optional<ItemId> found = item_from(*wrapped, wrap->select);
      require(faulty || (found && (*wrapped)[*found].kind == ItemKind::group),
              "wrap " + name + ": nothing to select\n" + wrapped->text());
      // In JSON, the objects of a group come before those of the groups in it.
      const bool reordered = !document.is_xml() && (document[item].kind == ItemKind::light ||
                                                    document[item].kind == ItemKind::primitive);
      require(faulty || reordered || same_meaning(document.scene(), wrapped->scene()),
              "wrap " + name + ": the scene differs\n" + wrapped->text());
    }
    const std::vector<ItemId> targets = targets_for(document, item);
    if (!targets.empty()) {
      const Result<Edit> edit = move_into(document, item, targets[below(targets.size())]);
      require(bool(edit), "move: " + error_text(edit));
      if (const auto moved = after(document, edit, "into " + name)) {
        const std::optional<ItemId> found = item_from(*moved, edit->select);
        require(faulty || moved->items().size() == document.items().size(),
                "move " + name + ": items\n" + moved->text());
        require(found && (*moved)[*found].name == document[item].name,
                "move " + name + ": lost\n" + moved->text());
        const std::optional<Handle> before = handle_of(document, item);
        const std::optional<Handle> now =
            found && before && before->item == item ? handle_of(*moved, *found) : std::nullopt;
        if (now && std::abs(glm::determinant(glm::dmat3(now->world_from_space))) > 1e-6) {
          const glm::dmat4 by = now->world_from_item - before->world_from_item;
          double size = 1;
          double error = 0;
          for (int column = 0; column < 4; ++column) {
            size = std::max(size, glm::length(before->world_from_item[column]));
            error = std::max(error, glm::length(by[column]));
          }
          require(faulty || error < 1e-3 * size, "move " + name + ": elsewhere\n" + moved->text());
        }
      }
    }
  }

  void placing(const Document& document, ItemId item) {
    const std::optional<Handle> handle = handle_of(document, item);
    if (!handle || std::abs(glm::determinant(glm::dmat3(handle->world_from_space))) < 1e-9) {
      return;
    }
    const auto number = [&] { return (static_cast<double>(below(2001)) - 1000) / 250; };
    glm::dmat4 target(1);
    const bool sheared = below(4) == 0;
    if (handle->is_light || sheared) {
      for (int column = 0; column < 3; ++column) {
        target[column] = {number(), number(), number(), 0};
      }
      target[3] = {number(), number(), number(), 1};
    } else {
      const glm::dvec3 axis(number(), number(), 1 + std::abs(number()));
      const glm::dmat4 turn =
          glm::dmat4(glm::mat3_cast(glm::angleAxis(number(), glm::normalize(axis))));
      glm::dmat4 local(1);
      local[3] = {number(), number(), number(), 1};
      local = local * turn;
      const double size = 0.1 + std::abs(number());
      local[0] *= size;
      local[1] *= 0.1 + std::abs(number());
      local[2] *= 0.1 + std::abs(number());
      target = handle->world_from_space * local;
    }
    const std::string name =
        fmt::format("place {} at {}", document[item].name, document[item].range.from);
    const Result<Edit> edit = place_item(document, *handle, target);
    require(bool(edit), name + ": " + error_text(edit));
    const auto placed = after(document, edit, name, false);
    if (!placed || !failure_.empty()) {
      return;
    }
    require(placed->items().size() == document.items().size(), name + ": items");
    const std::optional<Handle> now = failure_.empty() ? handle_of(*placed, item) : std::nullopt;
    require(now.has_value(), name + ": lost\n" + placed->text());
    if (!now) {
      return;
    }
    double size = 1;
    double off = 0;
    for (int column = handle->is_light ? 3 : 0; column < 4; ++column) {
      for (int row = 0; row < 3; ++row) {
        size = std::max(
            {size, std::abs(target[column][row]), std::abs(handle->world_from_space[column][row])});
        off = std::max(off, std::abs(now->world_from_item[column][row] - target[column][row]));
      }
    }
    require(off <= 1e-4 * size, fmt::format("{}: off by {}\n{}", name, off, placed->text()));
  }

  // One random edit of a document.
  std::pair<std::string, Result<Edit>> random_edit(const Document& document) {
    const auto item = static_cast<ItemId>(below(document.items().size()));
    const std::string name = document[item].name;
    switch (below(document.items().size() > 60 ? 8 : 10)) {
      case 0:
        return {"remove " + name, remove_item(document, item)};
      case 1:
        return {"reorder " + name, reorder_item(document, item, below(2) == 0 ? -1 : 1)};
      case 2: {
        const std::vector<ItemId> targets = targets_for(document, item);
        return {"into " + name, targets.empty()
                                    ? Result<Edit>(Error{"no target"})
                                    : move_into(document, item, targets[below(targets.size())])};
      }
      case 3: {
        const std::optional<Handle> handle = handle_of(document, item);
        const int axis = static_cast<int>(below(3));
        glm::dvec3 delta(0);
        delta[axis] = 0.25;
        return {"move " + name, !handle         ? Result<Edit>(Error{"no handle"})
                                : below(3) == 0 ? move_item(document, *handle, delta)
                                : below(2) == 0 ? turn_item(document, *handle, axis, 30)
                                                : scale_item(document, *handle, axis, 1.25)};
      }
      case 8:
        return {"duplicate " + name, duplicate_item(document, item)};
      case 9: {
        const std::vector<NewItem> kinds = kinds_to_add(document, item);
        const NewItem& kind = kinds[below(kinds.size())];
        return {"add " + kind.name, add_item(document, item, kind)};
      }
      case 7:
        return {"wrap " + name,
                below(3) == 0 ? wrap_in_group(document, item) : Result<Edit>(Error{"not now"})};
      default:
        break;
    }
    const std::vector<FieldView> fields = document.fields(item);
    if (fields.empty()) {
      return {"set", Error{"no field"}};
    }
    const FieldView& field = fields[below(fields.size())];
    const std::size_t part = below(field.parts.size());
    if (below(6) == 0) {
      return {fmt::format("unset {} {}", name, field.name), remove_value(document, item, field)};
    }
    const std::optional<std::string> value = other_value(field, part);
    const std::string what = fmt::format("set {} {} part {}", name, field.name, part);
    return {what, value ? set_value(document, item, field, part, *value)
                        : Result<Edit>(Error{"no other value"})};
  }

 private:
  std::mt19937& chance_;
  EditCounts& counts_;
  std::string failure_;
};

}  // namespace

std::string check_edits(const Document& document, std::size_t most, std::mt19937& chance,
                        EditCounts& counts) {
  Laws laws(chance, counts);
  const std::size_t count = document.items().size();
  const std::size_t step = std::max<std::size_t>(1, count / std::max<std::size_t>(most, 1));
  for (std::size_t at = count > most ? laws.below(step) : 0; at < count; at += step) {
    const auto item = static_cast<ItemId>(at);
    laws.fields(document, item);
    laws.there_and_back(document, item);
    laws.grouping(document, item);
    laws.placing(document, item);
    if (!laws.failure().empty()) {
      return laws.failure();
    }
  }
  return {};
}

std::string check_series(const Document& document, std::size_t length, std::mt19937& chance,
                         EditCounts& counts) {
  Laws laws(chance, counts);
  Document now = document;
  std::vector<Edit> undo;
  for (std::size_t i = 0; i < length; ++i) {
    const auto [what, edit] = laws.random_edit(now);
    const bool keeps = !what.starts_with("remove") && !what.starts_with("duplicate") &&
                       !what.starts_with("unset") && !what.starts_with("set");
    const std::optional<Document> next = laws.after(now, edit, what, keeps);
    if (!laws.failure().empty()) {
      return fmt::format("edit {}: {}\nof\n{}", i, laws.failure(), now.text());
    }
    if (next) {
      undo.push_back(inverse(now.text(), *edit));
      now = *next;
    }
  }
  std::string text = now.text();
  for (; !undo.empty(); undo.pop_back()) {
    text = applied(text, undo.back());
  }
  return text == document.text() ? std::string() : "undo of all edits differs\n" + text;
}

}  // namespace scenefile::testing
