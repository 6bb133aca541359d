#pragma once
// The tokens of an XML text, to its last byte. Private to the room.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace scenefile {

enum class XmlTokenKind : std::uint8_t {
  start,  ///< <a>
  empty,  ///< <a/>
  end,    ///< </a>
  text,   ///< with something that is not blank
  comment,
  cdata,
  other,  ///< declarations, processing instructions, the DOCTYPE
};

/// Offsets in the text. Blanks between tokens are no tokens.
struct XmlToken {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  XmlTokenKind kind = XmlTokenKind::text;
  bool verbatim = false;  ///< of a start: the element holds text alone, or says xml:space

  std::string_view of(std::string_view text) const { return text.substr(begin, end - begin); }
};

/// `text` is well-formed XML of less than 4 GiB, in any encoding whose bytes below 128 are ASCII.
std::vector<XmlToken> xml_tokens(std::string_view text);

/// One past the tag, comment, CDATA section or declaration whose `<` stands at `begin`; the end of
/// the text when it has none. Of any text.
std::size_t markup_end(std::string_view text, std::size_t begin);

/// The parts of a tag without the blanks between them: "<a" or "</a", name and quoted value of each
/// attribute, and at last ">" or "/>".
std::vector<std::string_view> tag_parts(std::string_view tag);

}  // namespace scenefile
