#pragma once
// Explains to its author why a text is not well-formed XML. Internal to the room.

#include "scenefile/base/diagnostics.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace scenefile {

enum class SyntaxFault : std::uint8_t {
  tag_mismatch,
  cut_off,
  duplicate_attribute,
  undefined_entity,
  bad_character_reference,
  junk_after_document,
  late_declaration,
  invalid_token,
  other
};

struct OpenElement {
  std::string_view name;
  Location location;
};

/// The offset of the first reference to an entity not predefined in XML; npos if there is none.
std::size_t find_entity_use(std::string_view markup);

/// Reports the fault at offset `at` of `text`. `detail` is the XML library's message, for
/// SyntaxFault::other; `open` lists the open elements.
void report_syntax(SyntaxFault fault, std::string_view detail, std::string_view text,
                   std::size_t at, std::span<const OpenElement> open, Diagnostics& diagnostics);

}  // namespace scenefile
