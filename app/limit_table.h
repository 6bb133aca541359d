#pragma once
// The limits of base/limits.h by name, for --limit and its help.

#include "scenefile/base/limits.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace scenefile::app {

struct LimitRow {
  std::string_view name;  ///< "file-bytes"
  std::string_view help;  ///< what is counted
  bool bytes;             ///< K, M and G may stand behind the number
  std::uint64_t most;     ///< that may be asked for
  std::uint64_t (*get)(const Limits&);
  void (*set)(Limits&, std::uint64_t);
};

/// In the order of the struct.
std::span<const LimitRow> limit_table();

/// Takes "name=value" over. Returns what is wrong with it in words; empty: nothing.
std::string set_limit(Limits& limits, const std::string& assignment);

/// A whole number of bytes from `min` to `max`; K, M or G behind it stand for 2^10, 2^20 and 2^30.
/// Returns what is wrong with the text in words; empty: nothing.
std::string parse_bytes(const std::string& text, std::uint64_t min, std::uint64_t max,
                        std::uint64_t& bytes);

/// What `scenefile help limits` says, in lines of that width.
std::string limits_text(std::size_t width);

}  // namespace scenefile::app
