#pragma once
// JSON laid out afresh. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"

#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// Nothing, after an error, when `text` is no JSON object. It is UTF-8 without a byte order mark.
std::optional<std::string> lay_out_json(std::string_view text, const Limits& limits,
                                        Diagnostics& diagnostics);

}  // namespace scenefile
