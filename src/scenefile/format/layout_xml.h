#pragma once
// Formats XML. Private to the room.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"

#include <string>
#include <string_view>

namespace scenefile {

/// Returns whether `text`, UTF-8 without a byte order mark, is a well-formed XML <scenefile>;
/// reports an error otherwise.
bool check_xml_layout(std::string_view text, const Limits& limits, Diagnostics& diagnostics);

/// Formats `text`, which may be in any encoding that is a superset of ASCII.
std::string lay_out_xml(std::string_view text);

}  // namespace scenefile
