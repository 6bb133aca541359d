#pragma once
// Splits XML tags, as written, into names and attributes; used by all readers of XML. Internal to
// the room.

#include "scenefile/base/limits.h"
#include "scenefile/base/location.h"
#include "scenefile/format/text_places.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace scenefile {

/// `name` points into the text of the file, so that its place can be found; so does `value`, unless
/// references in it were replaced.
struct XmlAttribute {
  std::string_view name;
  std::string_view value;
};

/// Only valid during the call that receives it.
struct XmlTag {
  std::string_view name;  ///< points into the text of the file, directly after the `<`
  std::span<const XmlAttribute> attributes;
  Location location;  ///< of the `<`

  const XmlAttribute* find(std::string_view attribute) const;
};

struct TagScan {
  std::string_view name;
  std::size_t size = 0;   ///< in bytes, with the `>`; to the end of the text if it is truncated
  bool is_end = false;    ///< </a>
  bool is_empty = false;  ///< <a/>
  /// Well-formed without a doubt: a name in ASCII, at most 16 attributes, values without references
  /// and line breaks. Only Expat can tell of other tags.
  bool plain = true;
  bool needs_decoding = false;  ///< a value contains a reference or a line break
};

/// Finds the parts of the tag at the beginning of any text. Values are as written, without their
/// quotes and with references unresolved. A tag that is not well-formed ends at the first `>`
/// outside of quotes, and its attributes are those before the mistake.
TagScan scan_tag(std::string_view text, std::vector<XmlAttribute>& attributes);

/// Only the size.
std::size_t tag_size(std::string_view text);

/// Why a tag is rejected before it is interpreted.
enum class TagFault : std::uint8_t { none, name_too_long, too_many_attributes, value_too_long };

struct TagVerdict {
  TagFault fault = TagFault::none;
  std::string_view culprit;  ///< for value_too_long: the name of the attribute
};
TagVerdict check_tag(std::string_view name, std::span<const XmlAttribute> attributes,
                     const Limits& limits);

/// Classes of characters in plain XML, as bits.
enum CharacterClass : std::uint8_t {
  blank = 1,
  name_start = 2,
  name_part = 4,
  value_part = 8,    ///< of a value in either quotes
  comment_part = 16  ///< but for the dash
};

/// Bytes from 128 on are in no class.
constexpr std::array<std::uint8_t, 256> make_character_classes() {
  std::array<std::uint8_t, 256> classes{};
  for (unsigned c = ' '; c < 128; ++c) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':';
    const bool digit = (c >= '0' && c <= '9') || c == '-' || c == '.';
    const bool special = c == '<' || c == '>' || c == '&' || c == '"' || c == '\'';
    classes[c] = static_cast<std::uint8_t>((letter ? name_start | name_part : 0) |
                                           (digit ? name_part : 0) | (special ? 0 : value_part) |
                                           (c == '-' || c == '>' ? 0 : comment_part));
  }
  for (const unsigned c : {' ', '\t', '\n', '\r'}) {
    classes[c] |= blank | comment_part;
  }
  return classes;
}
inline constexpr std::array<std::uint8_t, 256> character_classes = make_character_classes();

inline bool is(char c, CharacterClass what) {
  return (character_classes[static_cast<unsigned char>(c)] & what) != 0;
}

inline const char* skip(const char* p, const char* end, CharacterClass what) {
  while (p != end && is(*p, what)) {
    ++p;
  }
  return p;
}

/// Whether XML allows the character beyond ASCII that `text` begins with; its size in bytes, or 0.
std::size_t plain_character(std::string_view text);

}  // namespace scenefile
