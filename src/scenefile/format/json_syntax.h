#pragma once
// Says in words why a text is not JSON. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/format/json_parser.h"
#include "scenefile/format/json_repair.h"

#include <string_view>

namespace scenefile {

/// Reports the fault with its place, what was found, and what to write instead.
void report_json_error(const JsonError& error, std::string_view text, const Limits& limits,
                       Diagnostics& diagnostics);

/// Reports each fault and writes over it, as long as that can be done, so that the next one shows
/// and what is right behind it can be read; of those that are alike in a line only the first.
/// `repaired` is what was parsed, `text` what the author wrote. True: `tape` holds a view of
/// `repaired` at the end.
bool recover_json(JsonError error, std::string_view text, const Limits& limits,
                  RepairedJson& repaired, JsonTape& tape, Diagnostics& diagnostics);

}  // namespace scenefile
