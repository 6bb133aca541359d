#pragma once
// Says in words why a text is not JSON. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/format/json_parser.h"

#include <string_view>

namespace scenefile {

/// Reports the fault with its place, what was found, and what to write instead.
void report_json_error(const JsonError& error, std::string_view text, const Limits& limits,
                       Diagnostics& diagnostics);

}  // namespace scenefile
