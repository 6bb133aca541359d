#pragma once
// Asks Expat whether a text is well-formed XML. Internal to format.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/format/xml_scanner.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

enum class SyntaxFault : std::uint8_t {
  none,
  tag_mismatch,
  cut_off,
  duplicate_attribute,
  undefined_entity,
  bad_character_reference,
  junk_after_document,
  late_declaration,
  invalid_token,
  declaration,  ///< of an entity or of default attributes: well-formed, but refused
  over_limit,   ///< the markup at that place has a LimitFault
  other
};

struct XmlFault {
  SyntaxFault kind = SyntaxFault::none;
  std::size_t at = 0;   ///< everything before is well-formed; the size of the text for `none`
  std::string message;  ///< of a declaration; for `other`, that of Expat
};

/// The first fault of `text`, UTF-8 without a byte order mark. Reports a DOCTYPE that names another
/// file.
XmlFault find_fault(std::string_view text, const Limits& limits, Diagnostics& diagnostics);

struct LimitFault {
  const Code* code;
  std::string message;
};

/// The limit that a tag, comment or declaration exceeds, if any.
std::optional<LimitFault> limit_fault(const XmlToken& token, const Limits& limits);

}  // namespace scenefile
