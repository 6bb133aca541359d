#include "scenefile/lsp/completion.h"

#include "scenefile/base/ascii.h"
#include "scenefile/format/json_parser.h"
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

// A tag that is not finished before a place.
struct OpenTag {
  bool closing = false;
  std::size_t name_start = 0;
  std::size_t name_end = 0;
  std::string_view name;
  std::vector<std::string_view> attributes;  // those with a =
  char quote = '\0';                         // of the value at the place, or none
  std::size_t value = 0;                     // where that begins
};

struct XmlPlace {
  bool in_markup = false;  // a comment, CDATA, a declaration
  std::vector<std::string_view> open;
  std::optional<OpenTag> tag;
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
      tag.quote = c == tag.quote ? '\0' : tag.quote;
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
      tag.attributes.push_back(word);
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
      const auto last = std::find(place.open.rbegin(), place.open.rend(), tag.name);
      if (last != place.open.rend()) {
        place.open.erase(last.base() - 1, place.open.end());
      }
    } else if (text[at - 1] != '/') {
      place.open.push_back(tag.name);
    }
    ++at;
  }
  return place;
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
                         const std::vector<std::string_view>& open) {
  constexpr std::string_view top[] = {"scenefile"};
  const ElementWord* const parent = open.empty() ? nullptr : find_element(open.back());
  const bool only_name = tag_goes_on(text, tag.name_end);
  Completion result{tag.name_start, only_name ? tag.name_end : offset, {}};
  for (const std::string_view name : open.empty()        ? std::span(top)
                                     : parent != nullptr ? parent->children
                                                         : std::span<const std::string_view>()) {
    const ElementWord& element = *find_element(name);
    result.items.push_back({std::string(name), WordKind::element, element.about,
                            only_name ? std::string(name) : inserted_tag(element)});
  }
  if (!open.empty() && tag.name_start == offset) {
    const std::string end = fmt::format("/{}", open.back());
    result.items.push_back({end, WordKind::element, {}, only_name ? end : end + ">"});
  }
  return result;
}

Completion complete_end(std::string_view text, const OpenTag& tag, std::size_t offset,
                        const std::vector<std::string_view>& open) {
  Completion result{tag.name_start, std::max(tag.name_end, offset), {}};
  if (!open.empty()) {
    const std::string name(open.back());
    const bool ended = next_character(text, tag.name_end) == '>';
    result.items.push_back({name, WordKind::element, {}, ended ? name : name + ">"});
  }
  return result;
}

Completion complete_value(std::string_view text, const OpenTag& tag, std::size_t offset,
                          const ElementWord& element) {
  const std::size_t word = end_of_word(text, offset);
  const bool closed = word < text.size() && text[word] == tag.quote;
  Completion result{tag.value, closed ? word : offset, {}};
  const AttributeWord* const attribute =
      tag.attributes.empty() ? nullptr : find_attribute(element, tag.attributes.back());
  for (const std::string_view value :
       attribute != nullptr ? attribute->values : std::span<const std::string_view>()) {
    result.items.push_back({std::string(value), WordKind::value, {}, std::string(value)});
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
  OpenTag whole;  // with the attributes after the place
  std::size_t at = tag.name_start - 1;
  read_tag(text, text.size(), at, whole);
  Completion result{from, replaces ? word : offset, {}};
  for (const AttributeWord& attribute : element.attributes) {
    const bool given = std::find(whole.attributes.begin(), whole.attributes.end(),
                                 attribute.name) != whole.attributes.end();
    if (!given || (has_value && attribute.name == text.substr(from, word - from))) {
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
  return tag.quote != '\0' ? complete_value(text, tag, offset, *element)
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
  for (const std::string_view value :
       key != nullptr ? key->values : std::span<const std::string_view>()) {
    const std::string word = fmt::format("\"{}\"", value);
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
