#pragma once
// Mistakes in XML that begin in front of the place where a parser notices them. Internal to the
// room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/format/xml_syntax_error.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace scenefile {

/// The name that the text begins with; empty where it begins with none.
std::string_view name_at(std::string_view text);

/// What is wrong, and where.
struct SyntaxCause {
  const Code* code;
  std::size_t at;  ///< offset in the text
  std::string message;
};

/// The mistake behind the fault that a parser reported at the offset; nothing where the offset
/// itself is the place to look at.
std::optional<SyntaxCause> find_cause(SyntaxFault fault, std::string_view text, std::size_t at,
                                      std::span<const OpenElement> open);

}  // namespace scenefile
