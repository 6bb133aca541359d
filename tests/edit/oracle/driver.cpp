// Makes the edits that oracle.mjs asks for: driver SCENE, one operation a line on standard input.

#include "scenefile/edit/edits.h"

#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using namespace scenefile;

namespace {

constexpr const char* kinds[] = {"globals", "camera",    "light",    "root",  "template",
                                 "group",   "primitive", "instance", "unread"};

std::vector<std::string> words_in(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream in(line);
  for (std::string word; std::getline(in, word, '\t');) {
    words.push_back(word);
  }
  return words;
}

std::optional<ItemId> item_named(const Document& document, const std::string& kind,
                                 const std::string& from) {
  for (ItemId id = 0; id < document.items().size(); ++id) {
    const SceneItem& item = document[id];
    if (kinds[static_cast<int>(item.kind)] == kind &&
        (kind == "root" || kind == "globals" || kind == "camera" ||
         std::to_string(item.range.from) == from)) {
      return id;
    }
  }
  return std::nullopt;
}

// The nth field of that name.
std::optional<FieldView> field_named(const Document& document, ItemId item, const std::string& name,
                                     int nth) {
  for (const FieldView& field : document.fields(item)) {
    if (field.name == name && nth-- == 0) {
      return field;
    }
  }
  return std::nullopt;
}

Result<Edit> edited(const Document& document, const std::vector<std::string>& words) {
  const std::string& op = words[0];
  std::optional<ItemId> item;
  if (words[1] != "none") {
    item = item_named(document, words[1], words[2]);
    if (!item) {
      return Error{"no such item"};
    }
  }
  const auto number = [&](std::size_t i) { return std::stoi(words[i]); };
  if (op == "set" || op == "unset" || op == "movetransform") {
    const auto field = field_named(document, *item, words[3], number(4));
    if (!field) {
      return Error{"no such field"};
    }
    return op == "set"     ? set_value(document, *item, *field, static_cast<std::size_t>(number(5)),
                                   words.size() > 6 ? words[6] : "")
           : op == "unset" ? remove_value(document, *item, *field)
                           : move_transform(document, *item, *field, number(5));
  }
  if (op == "add") {
    for (const NewItem& kind : kinds_to_add(document, item)) {
      if (kinds[static_cast<int>(kind.kind)] == words[3] &&
          kind.name == (words.size() > 4 ? words[4] : "")) {
        return add_item(document, item, kind);
      }
    }
    return Error{"not offered"};
  }
  if (op == "addtransform") {
    return add_transform(document, *item, words[3]);
  }
  if (op == "remove") {
    return remove_item(document, *item);
  }
  if (op == "duplicate") {
    return duplicate_item(document, *item);
  }
  if (op == "reorder") {
    return reorder_item(document, *item, number(3));
  }
  if (op == "wrap") {
    return wrap_in_group(document, *item);
  }
  if (op == "into") {
    const std::optional<ItemId> target = item_named(document, words[3], words[4]);
    return target ? move_into(document, *item, *target) : Result<Edit>(Error{"no such target"});
  }
  const std::optional<Handle> handle = handle_of(document, *item);
  if (!handle) {
    return Error{"no handle"};
  }
  if (op == "move") {
    glm::dvec3 delta(0);
    delta[number(3)] = 0.625;
    return move_item(document, *handle, delta, 1e-6);
  }
  return op == "turn" ? turn_item(document, *handle, number(3), 30)
                      : scale_item(document, *handle, number(3), 1.5);
}

}  // namespace

int main(int argc, char** argv) {
  std::ifstream in(argv[argc - 1], std::ios::binary);
  std::stringstream bytes;
  bytes << in.rdbuf();
  const Result<Document> document = Document::open(bytes.str(), {});
  if (!document) {
    std::printf("REFUSED\t%s\n", document.error().text.c_str());
    return 0;
  }
  for (ItemId id = 0; id < document->items().size(); ++id) {
    const SceneItem& item = (*document)[id];
    std::printf("I\t%s\t%u\t%u\t%s\n", kinds[static_cast<int>(item.kind)], item.range.from,
                item.range.to, item.name.c_str());
    for (const FieldView& field : document->fields(id)) {
      std::printf("F\t%s", std::string(field.name).c_str());
      for (const FieldPart& part : field.parts) {
        std::printf("\t%s", part.written ? part.value.c_str() : "\x1e");
      }
      std::printf("\n");
    }
  }
  std::printf("END\n");
  for (std::string line; std::getline(std::cin, line);) {
    const Result<Edit> edit = edited(*document, words_in(line));
    if (!edit) {
      std::printf("error %s\n", edit.error().text.c_str());
      continue;
    }
    if (!fits(*edit, document->text().size())) {
      std::printf("error changes overlap\n");
      continue;
    }
    const std::string after = applied(document->text(), *edit);
    std::printf("ok %zu %ld\n", after.size(),
                edit->select ? static_cast<long>(*edit->select) : -1L);
    std::fwrite(after.data(), 1, after.size(), stdout);
  }
  return 0;
}
