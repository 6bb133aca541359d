#pragma once
// A tokenizer for XML. Private to the room.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace scenefile {

enum class XmlTokenKind : std::uint8_t {
  start,  ///< <a>
  empty,  ///< <a/>
  end,    ///< </a>
  text,   ///< contains more than white space
  comment,
  cdata,
  other,  ///< declarations, processing instructions, the DOCTYPE
};

/// Offsets in the text. White space between tokens is not a token.
struct XmlToken {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  XmlTokenKind kind = XmlTokenKind::text;
  bool verbatim = false;  ///< of a start: the element contains only text, or has xml:space

  std::string_view of(std::string_view text) const { return text.substr(begin, end - begin); }
};

/// `text` must be well-formed XML of less than 4 GiB, in an encoding that is a superset of ASCII.
std::vector<XmlToken> xml_tokens(std::string_view text);

/// One past the tag, comment, CDATA section or declaration whose `<` is at `begin`; the end of the
/// text if it is not closed. Accepts any text.
std::size_t markup_end(std::string_view text, std::size_t begin);

}  // namespace scenefile
