#pragma once
// What is wrong with a text that is not well-formed XML, in words for its author. Internal to the
// room.

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

/// Offset of the first reference to an entity that XML itself does not define; npos: there is none.
std::size_t find_entity_use(std::string_view markup);

/// Reports the fault at offset `at` of `text`. `detail` is what the XML library calls it, for
/// SyntaxFault::other; `open` lists the elements around the place.
void report_syntax(SyntaxFault fault, std::string_view detail, std::string_view text,
                   std::size_t at, std::span<const OpenElement> open, Diagnostics& diagnostics);

}  // namespace scenefile
