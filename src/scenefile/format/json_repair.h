#pragma once
// Repairs invalid JSON: numbers that the course's programs accept, and faults that should not hide
// what comes after them. Private to the room.

#include "scenefile/base/diagnostics.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// A text with inserted zeros and overwritten faults.
struct RepairedJson {
  std::string text;
  std::vector<std::size_t> inserted;  ///< offsets of the zeros in `text`, ascending
  std::vector<std::size_t> unknown;   ///< offsets of numbers that could not be read, ascending

  /// Maps an offset in `text` to the original text.
  std::size_t original_offset(std::size_t offset) const;
  bool is_unknown(std::size_t offset) const {
    return !unknown.empty() && std::binary_search(unknown.begin(), unknown.end(), offset);
  }
};

/// Outside of strings, writes .6 as 0.6 and 1. as 1.0, each with a warning.
RepairedJson repair_json_numbers(std::string_view text, Diagnostics& diagnostics);

}  // namespace scenefile
