#pragma once
// Splits XML, as written, into tags, comments and text: the only code that walks XML. Internal to
// format.

#include "scenefile/base/location.h"

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

/// A start tag. Only valid during the call that receives it.
struct XmlTag {
  std::string_view name;  ///< points into the text of the file, directly after the `<`
  std::span<const XmlAttribute> attributes;
  Location location;  ///< of the `<`

  const XmlAttribute* find(std::string_view attribute) const;
};

enum class XmlTokenKind : std::uint8_t {
  start,  ///< <a>
  empty,  ///< <a/>
  end,    ///< </a>
  text,   ///< contains more than white space
  comment,
  cdata,
  other,  ///< declarations, processing instructions, the DOCTYPE
};

struct XmlToken {
  XmlTokenKind kind = XmlTokenKind::text;
  std::string_view written;  ///< with its brackets; text without white space around it
  /// Well-formed without a doubt, as far as one token shows: ASCII names, at most 16 attributes,
  /// values without references and line breaks. Expat must judge other tokens.
  bool plain = false;
  // Of a tag:
  bool unquoted = false;  ///< plain but for is_unquoted() attributes
  std::string_view name;
  std::vector<XmlAttribute> attributes;  ///< as written, without quotes
  bool needs_decoding = false;           ///< a value contains a reference or a line break
};

/// Of a token that is `unquoted`: whether this attribute is: `v=1`, `v=1"`, `v="1`, or `v=“1”`.
bool is_unquoted(const XmlAttribute& attribute);

/// The sizes in bytes of the quotation marks around a value that is_unquoted().
struct StrayMarks {
  std::size_t opening = 0;
  std::size_t closing = 0;
};
StrayMarks stray_marks(const XmlAttribute& attribute);

/// The size in bytes of the typographic quotation mark that `text` begins with, or 0.
std::size_t typographic_quote(std::string_view text);

/// Accepts any text in an encoding that is a superset of ASCII; only UTF-8 is plain. White space
/// between tokens is not a token. Markup that is not closed extends to the end of the text. A tag
/// that is not well-formed ends at the first `>` outside of quotes, and its attributes are those
/// before the mistake; a missing quotation mark is not such a mistake if the end of the value is
/// clear. `<--` counts as the start of a comment, which ends before the next `<` at the latest.
class XmlScanner {
 public:
  explicit XmlScanner(std::string_view text) : text_(text) {}

  /// Reads the next token. Returns false at the end of the text. Reuses the memory of `token`.
  bool next(XmlToken& token);

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace scenefile
