#pragma once
// Explains why a text is not valid JSON, and repairs it: numbers that the course's programs accept,
// and faults that should not hide what comes after them. Internal to format.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/format/json_parser.h"

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

/// Reports the fault: its place, what was found, and what to write instead.
void report_json_error(const JsonError& error, std::string_view text, const Limits& limits,
                       Diagnostics& diagnostics);

/// Reports each fault and overwrites it, as long as that is possible, to find further faults and to
/// read what comes after. Of several similar faults in a row it reports the first, and those with a
/// correction. `repaired` is the parsed text, `text` the author's. Returns true if the tape is
/// complete; it then keeps a view of `repaired`.
bool recover_json(JsonError error, std::string_view text, const Limits& limits,
                  RepairedJson& repaired, JsonTape& tape, Diagnostics& diagnostics);

}  // namespace scenefile
