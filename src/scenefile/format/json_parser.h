#pragma once
// Parses JSON, without recursion, into a flat list of places in the text. Internal to format; only
// json_parser.cpp uses the JSON library.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// Index into JsonTape::items.
using JsonIndex = std::uint32_t;

/// A value or a key. The first character in the text tells its type.
struct JsonItem {
  std::uint32_t offset;  ///< of its first byte in the text; for a string, of its opening quote
  std::uint32_t extent;  ///< array, object: number of items inside; otherwise: length in bytes
};

/// All keys and values in the order of the text. The contents of a container follow it; in an
/// object, keys and values alternate. Item 0 is the whole document.
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
  /// One past the item and its contents.
  JsonIndex end(JsonIndex item) const {
    return item + 1 + (is_object(item) || is_array(item) ? items[item].extent : 0);
  }
  /// The bytes of a scalar as written; a string without its quotes.
  std::string_view raw(JsonIndex item) const;
  /// The value of a string, with escapes resolved.
  std::string string(JsonIndex item) const;
};

enum class JsonFault : std::uint8_t {
  none,
  empty,  ///< only white space
  value,  ///< expected a value
  key,    ///< expected a key
  colon,
  object_comma,  ///< expected a comma or } after a member
  array_comma,   ///< expected a comma or ] after an element
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

/// Why a text is not valid JSON.
struct JsonError {
  JsonFault fault = JsonFault::none;
  std::size_t offset = 0;         ///< where the fault was detected
  std::vector<std::size_t> open;  ///< offsets of the open containers, outermost first
};

/// Parses strict JSON (RFC 8259) into the tape, which keeps a view of `text`. The text is at most 4
/// GiB. `max_depth` limits the nesting of arrays and objects.
JsonError parse_json(std::string_view text, std::uint32_t max_depth, JsonTape& tape);

}  // namespace scenefile
