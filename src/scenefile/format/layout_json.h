#pragma once
// Formats JSON. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"

#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// `text` is UTF-8 without a byte order mark. Returns nullopt, after an error, if it is not a JSON
/// object.
std::optional<std::string> lay_out_json(std::string_view text, const Limits& limits,
                                        Diagnostics& diagnostics);

}  // namespace scenefile
