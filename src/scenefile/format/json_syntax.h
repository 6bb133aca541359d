#pragma once
// Explains why a text is not valid JSON. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/format/json_parser.h"
#include "scenefile/format/json_repair.h"

#include <string_view>

namespace scenefile {

/// Reports the fault: its place, what was found, and what to write instead.
void report_json_error(const JsonError& error, std::string_view text, const Limits& limits,
                       Diagnostics& diagnostics);

/// Reports each fault and overwrites it, as long as that is possible, to find further faults and to
/// read what comes after. Reports only the first of several similar faults in a row. `repaired` is
/// the parsed text, `text` the author's. Returns true if the tape is complete; it then keeps a view
/// of `repaired`.
bool recover_json(JsonError error, std::string_view text, const Limits& limits,
                  RepairedJson& repaired, JsonTape& tape, Diagnostics& diagnostics);

}  // namespace scenefile
