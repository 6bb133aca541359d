#include "scenefile/lsp/outline.h"

#include "scenefile/base/limits.h"
#include "scenefile/base/number.h"
#include "scenefile/base/text.h"
#include "scenefile/format/json_parser.h"
#include "scenefile/format/write_text.h"
#include "scenefile/format/xml_scanner.h"
#include "scenefile/format/xml_values.h"
#include "scenefile/lsp/completion.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <unordered_set>
#include <utility>

namespace scenefile {

namespace {

constexpr std::size_t no_part = std::numeric_limits<std::size_t>::max();

bool read_component(std::string_view text, float& value) {
  const ParsedNumber number = parse_number(text);
  value = static_cast<float>(number.value);
  return number.error == NumberError::none && value >= 0 && value <= 1;
}

// Adds the names that are uses of a template if there is one with that name.
void add_uses(Outline& outline, std::vector<NameUse> perhaps) {
  std::unordered_set<std::string> declared;
  for (const NameUse& use : outline.names) {
    use.declares ? (void)declared.insert(use.name) : (void)0;
  }
  for (NameUse& use : perhaps) {
    if (declared.contains(use.name)) {
      outline.names.push_back(std::move(use));
    } else {
      outline.other_names.push_back(std::move(use.name));
    }
  }
  std::sort(outline.names.begin(), outline.names.end(),
            [](const NameUse& a, const NameUse& b) { return a.from < b.from; });
}

class XmlOutline {
 public:
  explicit XmlOutline(std::string_view text) : text_(text) {}

  Outline run() {
    XmlScanner scanner(text_);
    for (XmlToken token; scanner.next(token);) {
      const std::size_t end = offset(token.written) + token.written.size();
      if (token.kind == XmlTokenKind::start || token.kind == XmlTokenKind::empty) {
        open(token);
        if (token.kind == XmlTokenKind::empty) {
          close(end);
        }
      } else if (token.kind == XmlTokenKind::end && !open_.empty()) {
        close(end);
      }
    }
    while (!open_.empty()) {
      close(text_.size());
    }
    add_nested_templates();
    add_uses(outline_, std::move(empty_trees_));
    return std::move(outline_);
  }

 private:
  struct Open {
    std::size_t part = no_part;
    std::optional<NameUse> tree;  // the name, if it is a tree inside another one
    bool empty = true;
  };

  std::size_t offset(std::string_view part) const {
    return static_cast<std::size_t>(part.data() - text_.data());
  }

  // Of attributes whose names differ only in letter case that with the right one, as the reader.
  static std::string_view value_of(const XmlToken& token, std::string_view name) {
    const XmlAttribute* found = nullptr;
    for (const XmlAttribute& a : token.attributes) {
      const bool better = found == nullptr || (found->name != name && a.name == name);
      found = better && equal_ignoring_case(a.name, name) ? &a : found;
    }
    return found == nullptr ? std::string_view() : found->value;
  }

  void open(const XmlToken& token) {
    std::size_t part = no_part;
    std::optional<NameUse> tree;
    const std::string name = lower_case(token.name);
    if (!open_.empty()) {
      open_.back().empty = false;
    }
    if (name == "globaldata") {
      part = add(token, OutlineKind::globals, "globaldata", {});
    } else if (name == "cameradata") {
      part = add(token, OutlineKind::camera, "cameradata", {});
    } else if (name == "lightdata") {
      part = add(token, OutlineKind::light, "lightdata", {});
    } else if (name == "object") {
      part = add_object(token, tree);
    } else if (name == "type" && !open_.empty() && open_.back().part != no_part &&
               outline_.parts[open_.back().part].kind == OutlineKind::light) {
      outline_.parts[open_.back().part].detail = value_of(token, "v");
    } else if (kind_of_element(name) == ValueKind::color) {
      add_color(token);
    }
    add_values(token);
    open_.push_back({part, std::move(tree)});
    depth_ += part == no_part ? 0 : 1;
  }

  void close(std::size_t end) {
    Open& last = open_.back();
    if (last.part != no_part) {
      outline_.parts[last.part].to = end;
      --depth_;
    }
    if (last.tree) {
      (last.empty ? empty_trees_ : full_trees_).push_back(*std::move(last.tree));
    }
    open_.pop_back();
  }

  // A tree inside another one is a template if it is used as one, and no tree at the top has its
  // name.
  void add_nested_templates() {
    std::unordered_set<std::string> top;
    std::unordered_set<std::string> used;
    for (const NameUse& use : outline_.names) {
      (use.declares ? top : used).insert(use.name);
    }
    for (const NameUse& use : empty_trees_) {
      used.insert(use.name);
    }
    for (NameUse& tree : full_trees_) {
      if (used.contains(tree.name) && !top.contains(tree.name)) {
        tree.declares = true;
        outline_.names.push_back(std::move(tree));
      }
    }
  }

  std::size_t add(const XmlToken& token, OutlineKind kind, std::string_view name,
                  std::string_view detail) {
    outline_.parts.push_back(
        {kind, std::string(name), std::string(detail), offset(token.written), 0, depth_});
    return outline_.parts.size() - 1;
  }

  std::size_t add_object(const XmlToken& token, std::optional<NameUse>& tree) {
    const std::string type = lower_case(value_of(token, "type"));
    const std::string_view written = value_of(token, "name");
    const std::string name = unescaped_xml(written);
    const bool top = open_.size() == 1;
    if (!name.empty() && name != "root" && (type == "tree" || type == "master")) {
      const NameUse use{name, offset(written), offset(written) + written.size(),
                        top && type == "tree"};
      if (top || type == "master") {
        outline_.names.push_back(use);
      } else {
        tree = use;
      }
    }
    const OutlineKind kind = type == "primitive" ? OutlineKind::primitive
                             : type == "master"  ? OutlineKind::instance
                             : top               ? OutlineKind::tree
                                                 : OutlineKind::group;
    return add(token, kind, name.empty() ? type : name, type);
  }

  void add_values(const XmlToken& token) {
    const bool shape = equal_ignoring_case(token.name, "object") &&
                       equal_ignoring_case(value_of(token, "type"), "primitive");
    for (const XmlAttribute& a : token.attributes) {
      const bool word = equal_ignoring_case(a.name, "type") ||
                        (shape && equal_ignoring_case(a.name, "name")) ||
                        (equal_ignoring_case(token.name, "type") && a.name == "v");
      const bool number = !word && parse_number(a.value).error == NumberError::none;
      if (!a.value.empty() && (word || number)) {
        outline_.values.push_back({offset(a.value), offset(a.value) + a.value.size(), number});
      }
    }
  }

  void add_color(const XmlToken& token) {
    const auto& attributes = token.attributes;
    constexpr std::string_view names[] = {"r", "g", "b"};
    ColorValue color;
    if (attributes.size() < 3 || token.unquoted) {
      return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (attributes[i].name != names[i] || !read_component(attributes[i].value, color.rgb[i])) {
        return;
      }
    }
    color.from = offset(attributes[0].name);
    color.to = offset(attributes[2].value) + attributes[2].value.size() + 1;
    outline_.colors.push_back(color);
  }

  std::string_view text_;
  Outline outline_;
  std::vector<Open> open_;
  std::vector<NameUse> empty_trees_;  // inside others
  std::vector<NameUse> full_trees_;
  std::uint32_t depth_ = 0;
};

template <typename Owner, std::size_t N>
bool has_color(const ValueRow<Owner> (&rows)[N], std::string_view key) {
  return std::any_of(std::begin(rows), std::end(rows), [&](const ValueRow<Owner>& row) {
    return row.kind == ValueKind::color && row.json == key;
  });
}

class JsonOutline {
 public:
  explicit JsonOutline(std::string_view text) : text_(text) {}

  Outline run() {
    if (parse_json(text_, Limits().nesting, tape_).fault != JsonFault::none) {
      return {};
    }
    const auto count = static_cast<JsonIndex>(tape_.items.size());
    for (JsonIndex i = 0; i < count;) {
      close_before(i);
      i = open_.empty() || !open_.back().object ? value(i, {}) : value(i + 1, tape_.raw(i));
    }
    close_before(count);
    add_uses(outline_, std::move(groups_));
    return std::move(outline_);
  }

 private:
  struct Container {
    JsonIndex end = 0;
    bool object = false;
    std::string_view key;  // of the container, or of the list that it is in
    std::size_t part = no_part;
  };

  // Reads a scalar, or enters a container. Returns the next item.
  JsonIndex value(JsonIndex i, std::string_view key) {
    const bool object = tape_.is_object(i);
    if (!object && !tape_.is_array(i)) {
      scalar(i, key);
      end_ = tape_.items[i].offset + tape_.items[i].extent;
      return i + 1;
    }
    const std::string_view name = key.empty() && !open_.empty() ? open_.back().key : key;
    end_ = tape_.items[i].offset + 1;
    if (!object && (has_color(material_rows, key) || has_color(light_rows, key))) {
      add_color(i);
    }
    open_.push_back({tape_.end(i), object, name, object ? part_of(i, name) : no_part});
    return i + 1;
  }

  void scalar(JsonIndex i, std::string_view key) {
    if (open_.empty() || open_.back().part == no_part || !tape_.is_string(i)) {
      return;
    }
    OutlinePart& part = outline_.parts[open_.back().part];
    if (key == "type") {
      part.detail = tape_.string(i);
    } else if (key == "name") {
      part.name = tape_.string(i);
      if (part.kind == OutlineKind::tree || part.kind == OutlineKind::group) {
        const std::size_t from = tape_.items[i].offset + 1;
        const bool declares = part.kind == OutlineKind::tree;
        (declares ? outline_.names : groups_)
            .push_back({part.name, from, from + tape_.raw(i).size(), declares});
      }
    }
  }

  std::size_t part_of(JsonIndex i, std::string_view key) {
    OutlineKind kind;
    if (key == "globalData") {
      kind = OutlineKind::globals;
    } else if (key == "cameraData") {
      kind = OutlineKind::camera;
    } else if (key == "lights") {
      kind = OutlineKind::light;
    } else if (key == "primitives") {
      kind = OutlineKind::primitive;
    } else if (key == "groups") {
      kind = OutlineKind::group;
    } else if (key == "templateGroups") {
      kind = OutlineKind::tree;
    } else {
      return no_part;
    }
    const bool list = kind != OutlineKind::globals && kind != OutlineKind::camera;
    std::string name(key.substr(0, key.size() - (list ? 1 : 0)));
    outline_.parts.push_back({kind, std::move(name), {}, tape_.items[i].offset, 0, depth_});
    ++depth_;
    return outline_.parts.size() - 1;
  }

  void add_color(JsonIndex array) {
    ColorValue color;
    if (tape_.end(array) - array != 4) {
      return;
    }
    for (JsonIndex i = 0; i < 3; ++i) {
      if (!tape_.is_number(array + 1 + i) ||
          !read_component(tape_.raw(array + 1 + i), color.rgb[i])) {
        return;
      }
    }
    color.from = tape_.items[array].offset;
    color.to = text_.find(']', color.from) + 1;
    outline_.colors.push_back(color);
  }

  // Leaves the containers that end before the item.
  void close_before(JsonIndex i) {
    while (!open_.empty() && open_.back().end <= i) {
      end_ = text_.find(open_.back().object ? '}' : ']', end_) + 1;
      if (open_.back().part != no_part) {
        outline_.parts[open_.back().part].to = end_;
        --depth_;
      }
      open_.pop_back();
    }
  }

  std::string_view text_;
  JsonTape tape_;
  Outline outline_;
  std::vector<Container> open_;
  std::vector<NameUse> groups_;  // uses of a template if there is one with that name
  std::size_t end_ = 0;          // of what was read
  std::uint32_t depth_ = 0;
};

}  // namespace

Outline read_outline(std::string_view text) {
  return looks_like_xml(text) ? XmlOutline(text).run() : JsonOutline(text).run();
}

std::string color_text(const std::array<double, 3>& rgb, bool xml) {
  std::array<std::string, 3> parts;
  for (std::size_t i = 0; i < 3; ++i) {
    parts[i] = number_text(static_cast<float>(std::round(rgb[i] * 1000) / 1000));
  }
  return xml ? fmt::format(R"(r="{}" g="{}" b="{}")", parts[0], parts[1], parts[2])
             : fmt::format("[{}, {}, {}]", parts[0], parts[1], parts[2]);
}

}  // namespace scenefile
