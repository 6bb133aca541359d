#pragma once
// XML laid out afresh. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"

#include <string>
#include <string_view>

namespace scenefile {

/// Whether `text`, UTF-8 without a byte order mark, is a <scenefile> in well-formed XML; else there
/// is an error.
bool check_xml_layout(std::string_view text, const Limits& limits, Diagnostics& diagnostics);

/// Lays it out. `text` may be in any encoding whose bytes below 128 are ASCII.
std::string lay_out_xml(std::string_view text);

}  // namespace scenefile
