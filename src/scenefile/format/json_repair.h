#pragma once
// Numbers that are no JSON but that the course's programs read. Private to the room.

#include "scenefile/base/diagnostics.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// A text with zeros inserted.
struct RepairedJson {
  std::string text;
  std::vector<std::size_t> inserted;  ///< offsets of the zeros in `text`, ascending

  /// Where the byte at `offset` of `text` stands in the text as it was.
  std::size_t original_offset(std::size_t offset) const;
};

/// Writes .6 as 0.6 and 1. as 1.0, outside of strings, each with a warning. Everything else stays
/// as it is.
RepairedJson repair_json_numbers(std::string_view text, Diagnostics& diagnostics);

}  // namespace scenefile
