#include "scenefile/lsp/completion.h"

#include "scenefile/base/ascii.h"
#include "scenefile/base/shape.h"
#include "scenefile/base/text.h"
#include "scenefile/format/json_parser.h"
#include "scenefile/format/write_text.h"
#include "scenefile/lsp/outline.h"
#include "scenefile/scene/vocabulary_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace scenefile {

namespace {

constexpr std::string_view npos_blanks = " \t\r\n";

bool is_word(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':' ||
         c == '.' || c == '-';
}

std::size_t word_start(std::string_view text, std::size_t at) {
  while (at > 0 && is_word(text[at - 1])) {
    --at;
  }
  return at;
}

std::size_t end_of_word(std::string_view text, std::size_t at) {
  while (at < text.size() && is_word(text[at])) {
    ++at;
  }
  return at;
}

struct GivenAttribute {
  std::string_view name;
  std::string_view value;  // empty until its closing quote
};

struct OpenTag {
  bool closing = false;
  std::size_t name_start = 0;
  std::size_t name_end = 0;
  std::string_view name;
  std::vector<GivenAttribute> attributes;  // those with a =
  char quote = '\0';                       // of the value at the place, or none
  std::size_t value = 0;                   // where that begins
};

struct XmlPlace {
  bool in_markup = false;  // a comment, CDATA, a declaration
  std::vector<OpenTag> open;
  std::optional<OpenTag> tag;  // the one that is not finished before the place
};

// Reads the tag at `at` up to `end`. Returns whether it ends before; moves `at` to its end, or to
// the next tag.
bool read_tag(std::string_view text, std::size_t end, std::size_t& at, OpenTag& tag) {
  tag.closing = text.substr(at, end - at).starts_with("</");
  tag.name_start = at + (tag.closing ? 2 : 1);
  tag.name_end = end_of_word(text, tag.name_start);
  tag.name = text.substr(tag.name_start, tag.name_end - tag.name_start);
  std::string_view word;
  std::size_t i = tag.name_end;
  for (; i < end; ++i) {
    const char c = text[i];
    if (tag.quote != '\0') {
      if (c == tag.quote) {
        tag.quote = '\0';
        if (!tag.attributes.empty()) {
          tag.attributes.back().value = text.substr(tag.value, i - tag.value);
        }
      }
    } else if (c == '"' || c == '\'') {
      tag.quote = c;
      tag.value = i + 1;
    } else if (c == '>') {
      at = i;
      return true;
    } else if (c == '<') {
      at = i;  // a tag that was never closed
      return false;
    } else if (is_word(c)) {
      const std::size_t word_stop = end_of_word(text, i);
      word = text.substr(i, word_stop - i);
      i = word_stop - 1;
    } else if (c == '=') {
      tag.attributes.push_back({word, {}});
    }
  }
  at = std::string_view::npos;
  return false;
}

XmlPlace xml_place(std::string_view text, std::size_t offset) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> skipped{
      {{"<!--", "-->"}, {"<?", "?>"}, {"<![CDATA[", "]]>"}, {"<!", ">"}}};
  XmlPlace place;
  for (std::size_t at = 0; (at = text.find('<', at)) < offset;) {
    const auto* const other = std::find_if(skipped.begin(), skipped.end(), [&](const auto& pair) {
      return text.substr(at).starts_with(pair.first);
    });
    if (other != skipped.end()) {
      const std::size_t end = text.find(other->second, at + other->first.size());
      if (end == std::string_view::npos || end + other->second.size() > offset) {
        place.in_markup = true;
        return place;
      }
      at = end + other->second.size();
      continue;
    }
    OpenTag tag;
    const std::size_t start = at;
    if (!read_tag(text, offset, at, tag)) {
      if (at == std::string_view::npos) {
        place.tag = std::move(tag);
        return place;
      }
      at = std::max(at, start + 1);
      continue;
    }
    if (tag.closing) {
      const auto last = std::find_if(place.open.rbegin(), place.open.rend(),
                                     [&](const OpenTag& open) { return open.name == tag.name; });
      if (last != place.open.rend()) {
        place.open.erase(last.base() - 1, place.open.end());
      }
    } else if (text[at - 1] != '/') {
      place.open.push_back(std::move(tag));
    }
    ++at;
  }
  return place;
}

// The tag that is open at the place, with what follows there.
OpenTag whole_tag(std::string_view text, const OpenTag& tag) {
  OpenTag whole;
  std::size_t at = tag.name_start - 1;
  read_tag(text, text.size(), at, whole);
  return whole;
}

bool has_attribute(const OpenTag& tag, std::string_view name) {
  return std::any_of(tag.attributes.begin(), tag.attributes.end(),
                     [&](const GivenAttribute& given) { return given.name == name; });
}

// Whether the tag is that of an object that may be of this type, also if its type is not known yet.
bool may_be(const OpenTag& object, std::string_view type) {
  const auto given =
      std::find_if(object.attributes.begin(), object.attributes.end(),
                   [](const GivenAttribute& attribute) { return attribute.name == "type"; });
  const std::string_view word =
      given == object.attributes.end() ? std::string_view() : given->value;
  constexpr std::string_view types[] = {"tree", "master", "primitive"};
  const bool known = std::any_of(std::begin(types), std::end(types),
                                 [&](std::string_view t) { return equal_ignoring_case(t, word); });
  return !known || equal_ignoring_case(type, word);
}

// Trees have transblocks, primitives the rest.
bool belongs_in(std::string_view child, const OpenTag& parent) {
  return parent.name != "object" || may_be(parent, child == "transblock" ? "tree" : "primitive");
}

// The templates of the file that can be used at the place: not the one around it.
std::vector<std::string> template_names(std::string_view text, std::size_t offset) {
  Outline outline = read_outline(text);
  const auto around =
      std::find_if(outline.parts.begin(), outline.parts.end(), [&](const OutlinePart& part) {
        return part.kind == OutlineKind::tree && part.from < offset && offset < part.to;
      });
  std::vector<std::string> names;
  for (NameUse& use : outline.names) {
    if (use.declares && (around == outline.parts.end() || around->name != use.name)) {
      names.push_back(std::move(use.name));
    }
  }
  return names;
}

std::string inserted_tag(const ElementWord& element) {
  std::string text(element.name);
  for (const AttributeWord& attribute : element.attributes) {
    text += attribute.required ? fmt::format(" {}=\"\"", attribute.name) : std::string();
  }
  const bool container = !element.children.empty() && element.name != "object";
  return text + (container ? fmt::format("></{}>", element.name) : "/>");
}

// The first character after white space from the place on, or NUL.
char next_character(std::string_view text, std::size_t at) {
  at = text.find_first_not_of(npos_blanks, at);
  return at == std::string_view::npos ? '\0' : text[at];
}

// Whether the name that ends at the place is that of a tag with attributes or an end, which stay.
bool tag_goes_on(std::string_view text, std::size_t name_end) {
  const std::size_t at = std::min(text.find_first_not_of(npos_blanks, name_end), text.size());
  const std::size_t word = end_of_word(text, at);
  const char next = next_character(text, word);
  return word == at ? next == '>' || next == '/' : next == '=';
}

Completion complete_name(std::string_view text, const OpenTag& tag, std::size_t offset,
                         const std::vector<OpenTag>& open) {
  constexpr std::string_view top[] = {"scenefile"};
  const ElementWord* const parent = open.empty() ? nullptr : find_element(open.back().name);
  const bool only_name = tag_goes_on(text, tag.name_end);
  Completion result{tag.name_start, only_name ? tag.name_end : offset, {}};
  for (const std::string_view name : open.empty()        ? std::span(top)
                                     : parent != nullptr ? parent->children
                                                         : std::span<const std::string_view>()) {
    if (!open.empty() && !belongs_in(name, open.back())) {
      continue;
    }
    const ElementWord& element = *find_element(name);
    result.items.push_back({std::string(name), WordKind::element, element.about,
                            only_name ? std::string(name) : inserted_tag(element)});
  }
  if (!open.empty() && tag.name_start == offset) {
    const std::string end = fmt::format("/{}", open.back().name);
    result.items.push_back({end, WordKind::element, {}, only_name ? end : end + ">"});
  }
  return result;
}

Completion complete_end(std::string_view text, const OpenTag& tag, std::size_t offset,
                        const std::vector<OpenTag>& open) {
  Completion result{tag.name_start, std::max(tag.name_end, offset), {}};
  if (!open.empty()) {
    const std::string name(open.back().name);
    const bool ended = next_character(text, tag.name_end) == '>';
    result.items.push_back({name, WordKind::element, {}, ended ? name : name + ">"});
  }
  return result;
}

// The names that have a meaning for an object of that type; any other tree is free to choose.
std::vector<std::string> object_names(std::string_view text, const OpenTag& tag, std::size_t offset,
                                      bool top) {
  const OpenTag object = whole_tag(text, tag);
  std::vector<std::string> names;
  if (may_be(object, "primitive")) {
    names.insert(names.end(), shape_words.begin(), shape_words.end());
  }
  if (may_be(object, "master")) {
    const std::vector<std::string> templates = template_names(text, offset);
    names.insert(names.end(), templates.begin(), templates.end());
  }
  if (may_be(object, "tree") && top) {
    names.emplace_back("root");
  }
  return names;
}

Completion complete_value(std::string_view text, const OpenTag& tag, std::size_t offset,
                          const ElementWord& element, const std::vector<OpenTag>& open) {
  const std::size_t word = end_of_word(text, offset);
  const bool closed = word < text.size() && text[word] == tag.quote;
  Completion result{tag.value, closed ? word : offset, {}};
  const AttributeWord* const attribute =
      tag.attributes.empty() ? nullptr : find_attribute(element, tag.attributes.back().name);
  if (attribute == nullptr) {
    return result;
  }
  std::vector<std::string> values(attribute->values.begin(), attribute->values.end());
  if (element.name == "object" && attribute->name == "name") {
    values = object_names(text, tag, offset, open.size() == 1);
  }
  for (std::string& value : values) {
    std::string written;
    append_xml(written, value);
    result.items.push_back({std::move(value), WordKind::value, {}, std::move(written)});
  }
  return result;
}

Completion complete_attribute(std::string_view text, const OpenTag& tag, std::size_t offset,
                              const ElementWord& element) {
  const std::size_t from = word_start(text, offset);
  const std::size_t word = end_of_word(text, offset);
  const bool replaces = from < offset;
  const bool has_value = replaces && next_character(text, word) == '=';
  const std::string_view value = has_value ? "" : !replaces && word > offset ? "=\"\" " : "=\"\"";
  const OpenTag whole = whole_tag(text, tag);
  Completion result{from, replaces ? word : offset, {}};
  for (const AttributeWord& attribute : element.attributes) {
    const bool of_mesh = attribute.name == "filename" || attribute.name == "meshfile";
    if (of_mesh && !may_be(whole, "primitive")) {
      continue;
    }
    if (!has_attribute(whole, attribute.name) ||
        (has_value && attribute.name == text.substr(from, word - from))) {
      result.items.push_back({std::string(attribute.name), WordKind::attribute, attribute.about,
                              fmt::format("{}{}", attribute.name, value)});
    }
  }
  return result;
}

Completion complete_xml(std::string_view text, std::size_t offset) {
  const XmlPlace place = xml_place(text, offset);
  if (place.in_markup || !place.tag) {
    return {};
  }
  const OpenTag& tag = *place.tag;
  if (tag.closing) {
    return complete_end(text, tag, offset, place.open);
  }
  if (offset <= tag.name_end) {
    return complete_name(text, tag, offset, place.open);
  }
  const ElementWord* const element = find_element(tag.name);
  if (element == nullptr) {
    return {};
  }
  return tag.quote != '\0' ? complete_value(text, tag, offset, *element, place.open)
                           : complete_attribute(text, tag, offset, *element);
}

// An object or array around a place.
struct JsonAround {
  bool object = false;
  bool wants_key = false;
  std::string_view definition;  // ObjectWord::name
  bool known = true;            // whether the definition is
  std::string_view key;
  std::vector<std::string_view> keys;
};

struct JsonPlace {
  JsonAround here;
  std::size_t string = std::string_view::npos;  // the quote of the string at the place
};

JsonPlace json_place(std::string_view text, std::size_t offset) {
  std::vector<JsonAround> stack(1);
  std::size_t string = std::string_view::npos;
  for (std::size_t i = 0; i < offset; ++i) {
    const char c = text[i];
    JsonAround& here = stack.back();
    if (string != std::string_view::npos) {
      if (c == '\\') {
        ++i;
      } else if (c == '"') {
        if (here.object && here.wants_key) {
          here.key = text.substr(string + 1, i - string - 1);
          here.keys.push_back(here.key);
        }
        string = std::string_view::npos;
      }
    } else if (c == '"') {
      string = i;
    } else if (c == ':') {
      here.wants_key = false;
    } else if (c == ',') {
      here.wants_key = here.object;
    } else if (c == '{' || c == '[') {
      JsonAround below{c == '{', c == '{', here.definition, here.known, {}, {}};
      if (here.object) {
        const ObjectWord* const object = here.known ? find_object(here.definition) : nullptr;
        const KeyWord* const key = object != nullptr ? find_key(*object, here.key) : nullptr;
        below.known = key != nullptr && !key->object.empty();
        below.definition = below.known ? key->object : std::string_view();
      }
      stack.push_back(std::move(below));
    } else if ((c == '}' || c == ']') && stack.size() > 1) {
      stack.pop_back();
    }
  }
  return {stack.back(), string};
}

Completion complete_json(std::string_view text, std::size_t offset) {
  const auto [here, string] = json_place(text, offset);
  const ObjectWord* const object = here.known ? find_object(here.definition) : nullptr;
  if (!here.object || object == nullptr) {
    return {};
  }
  const bool in_string = string != std::string_view::npos;
  const std::size_t word = end_of_word(text, offset);
  const bool closed = in_string && word < text.size() && text[word] == '"';
  Completion result{in_string ? string : word_start(text, offset), closed ? word + 1 : offset, {}};
  if (here.wants_key) {
    const char next = next_character(text, result.to);
    for (const KeyWord& key : object->keys) {
      if (std::find(here.keys.begin(), here.keys.end(), key.name) == here.keys.end()) {
        const std::string label = fmt::format("\"{}\"", key.name);
        const std::string_view separator = next == '"' ? "," : "";
        result.items.push_back(
            {label, WordKind::attribute, key.about,
             next == ':' ? label : fmt::format("{}: {}{}", label, key.example, separator)});
      }
    }
    return result;
  }
  const KeyWord* const key = find_key(*object, here.key);
  if (key == nullptr) {
    return result;
  }
  std::vector<std::string> values(key->values.begin(), key->values.end());
  if (object->name == "group" && key->name == "name") {
    values = template_names(text, offset);
  }
  for (const std::string& value : values) {
    std::string word;
    append_json(word, value);
    result.items.push_back({word, WordKind::value, {}, word});
  }
  return result;
}

std::string_view about_xml(std::string_view text, std::size_t from, std::string_view name) {
  const XmlPlace place = xml_place(text, from);
  if (place.in_markup || !place.tag || place.tag->quote != '\0') {
    return {};
  }
  if (from == place.tag->name_start) {
    const ElementWord* const element = find_element(name);
    return element != nullptr ? element->about : std::string_view();
  }
  const ElementWord* const element = find_element(place.tag->name);
  const AttributeWord* const attribute =
      element != nullptr ? find_attribute(*element, name) : nullptr;
  return attribute != nullptr ? attribute->about : std::string_view();
}

std::string_view about_json(std::string_view text, std::size_t from, std::size_t to) {
  const std::size_t after = text.find_first_not_of(npos_blanks, to + 1);
  if (from == 0 || text[from - 1] != '"' || to >= text.size() || text[to] != '"' ||
      after == std::string_view::npos || text[after] != ':') {
    return {};
  }
  const JsonAround here = json_place(text, from - 1).here;
  const ObjectWord* const object = here.known ? find_object(here.definition) : nullptr;
  const KeyWord* const key =
      object != nullptr ? find_key(*object, text.substr(from, to - from)) : nullptr;
  return key != nullptr ? key->about : std::string_view();
}

}  // namespace

bool looks_like_xml(std::string_view text) {
  const std::size_t first = text.find_first_not_of(npos_blanks);
  return first == std::string_view::npos || text[first] == '<';
}

Completion complete(std::string_view text, std::size_t offset) {
  return looks_like_xml(text) ? complete_xml(text, offset) : complete_json(text, offset);
}

std::optional<WordMeaning> describe(std::string_view text, std::size_t offset) {
  WordMeaning word{word_start(text, offset), end_of_word(text, offset), {}};
  word.about = looks_like_xml(text)
                   ? about_xml(text, word.from, text.substr(word.from, word.to - word.from))
                   : about_json(text, word.from, word.to);
  return word.about.empty() ? std::nullopt : std::optional(word);
}

std::size_t word_end(std::string_view text, std::size_t offset) {
  if (offset >= text.size()) {
    return offset;
  }
  if (text[offset] == '"') {
    const std::size_t end = text.find_first_of("\"\r\n", offset + 1);
    return end == std::string_view::npos ? text.size() : end + (text[end] == '"' ? 1 : 0);
  }
  std::size_t at = offset;
  at += text[at] == '<' ? 1 : 0;
  at += at < text.size() && text[at] == '/' ? 1 : 0;
  at = end_of_word(text, at);
  return at > offset ? at : offset + 1;
}

}  // namespace scenefile
