#pragma once
// JSON text as a flat list of places, made without recursion. Private to the room; the JSON library
// stays inside json_parser.cpp.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// Index into JsonTape::items.
using JsonIndex = std::uint32_t;

/// A value or a key. Its first character says what it is.
struct JsonItem {
  std::uint32_t offset;  ///< of its first byte in the text; of the quote for a string
  std::uint32_t extent;  ///< array, object: how many items lie inside; else: its bytes
};

/// All keys and values in the order of the text. What a container holds follows it; in an object
/// keys and values alternate. The whole document is item 0.
struct JsonTape {
  std::string_view text;
  std::vector<JsonItem> items;

  char first_character(JsonIndex item) const { return text[items[item].offset]; }
  bool is_object(JsonIndex item) const { return first_character(item) == '{'; }
  bool is_array(JsonIndex item) const { return first_character(item) == '['; }
  bool is_string(JsonIndex item) const { return first_character(item) == '"'; }
  bool is_number(JsonIndex item) const {
    const char c = first_character(item);
    return c == '-' || (c >= '0' && c <= '9');
  }
  /// One past the item and all that it holds.
  JsonIndex end(JsonIndex item) const {
    return item + 1 + (is_object(item) || is_array(item) ? items[item].extent : 0);
  }
  /// The bytes of a scalar as written, a string without its quotes.
  std::string_view raw(JsonIndex item) const;
  /// The characters that a string stands for.
  std::string string(JsonIndex item) const;
};

enum class JsonFault : std::uint8_t {
  none,
  empty,  ///< nothing but white space
  value,  ///< no value where one must be
  key,    ///< no key where one must be
  colon,
  object_comma,  ///< neither comma nor } behind a member
  array_comma,   ///< neither comma nor ] behind an element
  unclosed_string,
  control_character,
  escape,
  surrogate,
  encoding,  ///< not UTF-8
  number,
  number_too_large,
  after_end,
  too_deep,
};

/// Why a text is not JSON.
struct JsonError {
  JsonFault fault = JsonFault::none;
  std::size_t offset = 0;         ///< where the fault was found
  std::vector<std::size_t> open;  ///< offsets of the containers that were open, outermost first
};

/// Reads strict JSON (RFC 8259) into the tape, which keeps a view of `text`. The text is at most
/// 4 GiB. `max_depth` bounds arrays and objects inside each other.
JsonError parse_json(std::string_view text, std::uint32_t max_depth, JsonTape& tape);

}  // namespace scenefile
