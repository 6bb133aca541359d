#pragma once
// Texts that are no JSON, made JSON: numbers that the course's programs read, and faults that need
// not hide what is behind them. Private to the room.

#include "scenefile/base/diagnostics.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// A text with zeros inserted and faults written over.
struct RepairedJson {
  std::string text;
  std::vector<std::size_t> inserted;  ///< offsets of the zeros in `text`, ascending
  std::vector<std::size_t> unknown;   ///< offsets of numbers that could not be read, ascending

  /// Where the byte at `offset` of `text` stands in the text as it was.
  std::size_t original_offset(std::size_t offset) const;
  bool is_unknown(std::size_t offset) const {
    return !unknown.empty() && std::binary_search(unknown.begin(), unknown.end(), offset);
  }
};

/// Writes .6 as 0.6 and 1. as 1.0, outside of strings, each with a warning. Everything else stays
/// as it is.
RepairedJson repair_json_numbers(std::string_view text, Diagnostics& diagnostics);

}  // namespace scenefile
