#pragma once
// The syntax of a scene file with the ranges of its parts, the same for XML and JSON. Internal to
// edit.

#include "scenefile/base/location.h"
#include "scenefile/base/result.h"
#include "scenefile/edit/text_edit.h"
#include "scenefile/format/json_parser.h"
#include "scenefile/format/read_scene.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// Index into Syntax::parts.
using PartId = std::uint32_t;
inline constexpr PartId no_part = ~PartId{0};

/// An XML element or a JSON value.
struct SyntaxPart {
  enum class Type : std::uint8_t { element, object, array, string, number, word };

  Type type = Type::element;
  bool empty = false;          ///< <a/>
  std::uint32_t from = 0;      ///< of the `<`, or of the key of a value in an object
  std::uint32_t to = 0;        ///< one past the element or value
  std::uint32_t body = 0;      ///< element: after its start tag; JSON: first byte of the value
  std::uint32_t close = 0;     ///< element: of its end tag
  std::uint32_t key_size = 0;  ///< of the name after the `<`, or of the key with its quotes
  JsonIndex item = 0;          ///< of a JSON value
  PartId parent = no_part;
  std::vector<PartId> children;

  TextRange range() const { return {from, to}; }
  TextRange value() const { return {body, to}; }  ///< of a JSON value, without its key
};

/// An attribute as written.
struct WrittenAttribute {
  std::string_view name;
  TextRange range;  ///< from its name to its closing quote
  TextRange value;  ///< without quotes
};

struct Syntax {
  std::string_view text;  ///< all bytes of the file
  bool xml = true;
  std::uint32_t start = 0;  ///< size of the byte order mark
  JsonTape tape;            ///< of JSON, without the byte order mark
  /// Ascending by `from`. The first is <scenefile> or the JSON document.
  std::vector<SyntaxPart> parts;
  std::vector<Location> places;  ///< of the parts, as the reader reports them

  const SyntaxPart& operator[](PartId id) const { return parts[id]; }
  /// The name of an element as written, or the key without its quotes.
  std::string_view name(PartId id) const;
  /// The part that begins at a place, or no_part.
  PartId at(Location place) const;
  std::vector<WrittenAttribute> attributes(PartId id) const;
  /// The index among the children of its parent.
  std::size_t index(PartId id) const;
  std::string_view slice(TextRange range) const { return text.substr(range.from, range.size()); }
};

/// Parses a file in UTF-8, ISO-8859-1 or windows-1252. Fails if it is not well-formed XML or valid
/// JSON, or is in UTF-16. The result keeps a view of `bytes`.
Result<Syntax> parse_syntax(std::string_view bytes, const ReadOptions& options);

}  // namespace scenefile
