#pragma once
// The small change of both writers. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/base/location.h"

#include <string>
#include <string_view>

namespace scenefile {

/// Adds `text` as the inside of an XML attribute. Characters that XML cannot hold become U+FFFD.
/// Returns whether all could be said.
bool append_xml(std::string& out, std::string_view text);

/// Adds `text` as a JSON string, quotes included. Bytes that are not UTF-8 become U+FFFD. Returns
/// whether all could be said.
bool append_json(std::string& out, std::string_view text);

/// Reports that the text would be nested deeper than readers allow.
void report_nesting(const Limits& limits, Diagnostics& diagnostics);

}  // namespace scenefile
