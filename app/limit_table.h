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
  std::string_view help;  ///< what is limited
  bool bytes;             ///< accepts the suffixes K, M and G
  std::uint64_t most;     ///< maximum value
  std::uint64_t (*get)(const Limits&);
  void (*set)(Limits&, std::uint64_t);
};

/// In the order of the struct.
std::span<const LimitRow> limit_table();

/// Parses "name=value". Returns an error text; empty on success.
std::string set_limit(Limits& limits, const std::string& assignment);

/// Parses a number of bytes from `min` to `max`; the suffixes K, M and G mean 2^10, 2^20 and 2^30.
/// Returns an error text; empty on success.
std::string parse_bytes(const std::string& text, std::uint64_t min, std::uint64_t max,
                        std::uint64_t& bytes);

/// The text of `scenefile help limits`, wrapped to that width.
std::string limits_text(std::size_t width);

}  // namespace scenefile::app
