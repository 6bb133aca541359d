#pragma once
// Explains to the author of a text why it is not well-formed XML, and repairs what it can. Internal
// to format.

#include "scenefile/base/diagnostics.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/format/text_places.h"
#include "scenefile/format/xml_judge.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace scenefile {

struct OpenElement {
  std::string_view name;
  Location location;
  std::size_t at = 0;  ///< the offset of its `<`
};

/// The offset of the first reference to an entity not predefined in XML; npos if there is none.
std::size_t find_entity_use(std::string_view markup);

/// Reports the fault of `text`, which may be repaired: repair() keeps the offsets of bytes.
/// `places`: of the file; `open`: the open elements.
void report_syntax(const XmlFault& fault, std::string_view text, std::span<const OpenElement> open,
                   TextPlaces& places, Diagnostics& diagnostics);

/// Reports the values of a token that is `unquoted`.
void report_unquoted(const XmlToken& token, TextPlaces& places, Diagnostics& diagnostics);

/// Reports that the end tag differs from the name of the innermost open element in its case.
void report_end_case(const XmlToken& end, std::string_view open, TextPlaces& places,
                     Diagnostics& diagnostics);

/// The text in which Expat finds the first fault after which nothing can be read. It has the same
/// length, with spaces in place of the attributes of tags that are `unquoted`, and with end tags in
/// the case of their start tags; the reader reports these errors where it meets them. Comments that
/// contain -- and comments that start with <-- are invalid in XML, but the parsers of the course's
/// programs accept them: what is wrong with them becomes spaces too, and is reported here. A
/// comment ends at the first -->. Returns nullopt if nothing was repaired.
std::optional<std::string> repair(std::string_view text, const ReadOptions& options,
                                  Diagnostics& diagnostics);

}  // namespace scenefile
